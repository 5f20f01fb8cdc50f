#pragma once
// Parameters of the viscoelastic penalty response (Sec. 5.4.3); its law is plane_force in
// dynamics/.

namespace thigma {

/// How clusters push. The stiffness is that of the contact as a whole: clusters share it in
/// proportion to depth + tolerance, so force grows neither with the number of contacts nor with
/// that of clusters, and a cluster enters with nothing.
struct PenaltyParams {
  double stiffness = 2000.0;  // k of all clusters together [N/m]
  double damping = 0.0;       // b of all clusters together [N s/m]
  double tolerance = 0.0;     // d of the contact query: force starts at depth = -d [m]
  bool is_divided_among_clusters =
      true;  // false: every cluster has the full k and b, as in Eq. 5.37
};

/// A response that is the gradient of one energy, k/2 S^(2/p), S = (1/A0) integral of w^p over the
/// area of contact, w = depth + tolerance. Stiffness k and damping b are those of PenaltyParams, of
/// an area A0 in even contact: of an area A they are (A/A0)^(2/p) times as much.
struct PotentialLaw {
  int exponent = 4;   // p: 2 (an elastic foundation of k/A0 [N/m^3]) or 4
  double area = 0.0;  // A0, > 0 [m^2]
};

}  // namespace thigma
