#include "reference/conformance/conformance.h"
#include "reference/refinement.h"

#include "thigma/contact/clustering.h"
#include "thigma/contact/error_metric.h"

namespace thigma::app {
namespace {

Contact read_contact(const JsonField& field) {
  Contact c;
  c.point = vector<3>(member(field, "p"));
  c.scene_point = vector<3>(member(field, "p0"));
  c.normal = vector<3>(member(field, "n"));
  c.depth = number(member(field, "delta"));
  return c;
}

ContactClusters read_clusters(const JsonField& field) {
  ContactClusters result;
  for (std::size_t i = 0; i < list_size(field); ++i) {
    const Contact c = read_contact(element(field, i));
    ContactCluster cluster;
    cluster.point = c.point;
    cluster.scene_point = c.scene_point;
    cluster.normal = c.normal;
    cluster.depth = c.depth;
    cluster.id = result.next_id++;
    if (!result.clusters.push_back(cluster)) fail_field(field, "at most 16 clusters");
  }
  return result;
}

void compare_cluster(const JsonField& want, const ContactCluster& got,
                     const std::vector<long>& members, CaseCheck& check) {
  check.compare(member(want, "p"), got.point, check.tolerance());
  check.compare(member(want, "p0"), got.scene_point, check.tolerance());
  check.compare(member(want, "n"), got.normal, check.tolerance());
  check.compare(member(want, "delta"), got.depth);
  check.compare(member(want, "w"), got.weight);
  check.expect_list(member(want, "members"), members);
}

LevelError read_level(const JsonField& in, const char* s, const char* r, const char* d) {
  LevelError level;
  level.deviation = number(member(in, s));
  level.is_free = member(in, r).is_null();
  if (!level.is_free) level.resolution = number(member(in, r));
  level.support_area = number(member(in, d));
  return level;
}

}  // namespace

void check_clustering(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const JsonField list = member(in, "contacts");
  std::vector<Contact> contacts;
  for (std::size_t i = 0; i < list_size(list); ++i)
    contacts.push_back(read_contact(element(list, i)));
  const ContactClusters previous = read_clusters(member(in, "old_clusters"));
  ClusterParams params;
  params.max_clusters = static_cast<int>(whole_number(member(in, "K")));
  params.tolerance = number(member(in, "d"));
  ClusterScratch scratch;
  ContactClusters got;
  cluster_contacts(contacts, previous, params, scratch, got);

  check.expect_list(check.take("initial_seeds"), {scratch.seeds.begin(), scratch.seeds.end()});
  const std::vector<long> assignment(
      scratch.assignment.begin(),
      scratch.assignment.begin() + static_cast<std::ptrdiff_t>(contacts.size()));
  check.expect_list(check.take("assignment"), assignment);
  check.expect_whole("iterations", got.iterations);
  check.expect("cost", got.cost);
  const JsonField want = check.take("clusters");
  if (list_size(want) != got.clusters.size()) return check.differ(want);
  for (std::size_t k = 0; k < got.clusters.size(); ++k) {
    std::vector<long> members;
    for (std::size_t i = 0; i < assignment.size(); ++i) {
      if (assignment[i] == static_cast<long>(k)) members.push_back(static_cast<long>(i));
    }
    compare_cluster(element(want, k), got.clusters[k], members, check);
  }
}

void check_error_metric(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const LevelError a = read_level(in, "s_a", "r_a", "D_a");
  const LevelError b = read_level(in, "s_b", "r_b", "D_b");
  const double weighted = weighted_deviation(a, b);
  check.expect("s_star", weighted);
  check.expect_flag("refine", needs_refinement(weighted, number(member(in, "s0"))));
  const double d = number(member(in, "d"));
  check.expect("pair_tolerance",
               pair_tolerance(d, number(member(in, "h_a")), number(member(in, "h_b"))));
  const JsonField view = member(in, "view");
  check.expect("view_s0", view_threshold({.pixels = number(member(view, "N")),
                                          .distance = number(member(view, "l")),
                                          .frustum_size = number(member(view, "f")),
                                          .near_distance = number(member(view, "n")),
                                          .image_size = number(member(view, "i"))}));
}

}  // namespace thigma::app
