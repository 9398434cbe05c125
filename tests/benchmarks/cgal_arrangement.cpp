// The same arrangement by CGAL: great circles on the sphere, or lines in one chart of it.
//
// usage: cgal_arrangement sphere|chart|incremental < normals
// Input: m, then m integer normals. Output: processor seconds, peak megabytes, vertices, edges, faces.
//
// "sphere" inserts all geodesic arcs by one sweep; "incremental" inserts them one by one;
// "chart" inserts the lines n_x x + n_y y + n_z = 0, which cover one half of the sphere.

#include <sys/resource.h>

#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include <CGAL/Arr_geodesic_arc_on_sphere_traits_2.h>
#include <CGAL/Arr_linear_traits_2.h>
#include <CGAL/Arr_spherical_topology_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Arrangement_on_surface_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Sphere_traits = CGAL::Arr_geodesic_arc_on_sphere_traits_2<Kernel>;
using Sphere = CGAL::Arrangement_on_surface_2<
    Sphere_traits, CGAL::Arr_spherical_topology_traits_2<Sphere_traits>>;
using Chart_traits = CGAL::Arr_linear_traits_2<Kernel>;
using Chart = CGAL::Arrangement_2<Chart_traits>;

struct Normal {
  int x, y, z;
};

template <class Arrangement>
void report(const Arrangement& arrangement, std::clock_t start) {
  const double elapsed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::cout << elapsed << ' ' << usage.ru_maxrss / 1024 << ' '
            << arrangement.number_of_vertices() << ' ' << arrangement.number_of_edges() << ' '
            << arrangement.number_of_faces() << '\n';
}

void on_sphere(const std::vector<Normal>& normals, bool sweep) {
  Sphere_traits traits;
  const auto make_curve = traits.construct_curve_2_object();
  const auto start = std::clock();
  std::vector<Sphere_traits::Curve_2> circles;
  for (const Normal& n : normals) circles.push_back(make_curve(Kernel::Direction_3(n.x, n.y, n.z)));
  Sphere arrangement(&traits);
  if (sweep) {
    CGAL::insert(arrangement, circles.begin(), circles.end());
  } else {
    for (const auto& circle : circles) CGAL::insert(arrangement, circle);
  }
  report(arrangement, start);
}

void in_chart(const std::vector<Normal>& normals) {
  const auto start = std::clock();
  std::vector<Chart_traits::Curve_2> lines;
  for (const Normal& n : normals) {
    if (n.x != 0 || n.y != 0) lines.push_back(Kernel::Line_2(n.x, n.y, n.z));
  }
  Chart arrangement;
  CGAL::insert(arrangement, lines.begin(), lines.end());
  report(arrangement, start);
}

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "sphere";
  std::size_t count = 0;
  std::cin >> count;
  std::vector<Normal> normals(count);
  for (Normal& n : normals) std::cin >> n.x >> n.y >> n.z;
  if (mode == "chart") {
    in_chart(normals);
  } else {
    on_sphere(normals, mode == "sphere");
  }
}
