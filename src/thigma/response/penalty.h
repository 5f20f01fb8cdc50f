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

}  // namespace thigma
