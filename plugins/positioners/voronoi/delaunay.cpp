// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL (it takes 12 s to compile).
#include "delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <stdexcept>
#include <string>

namespace voronoi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Base = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

}  // namespace

struct Delaunay::Triangulation : Base {
  // As clear(), but keeps the blocks of memory.
  void empty() {
    auto& faces = tds().faces();
    for (auto face = faces.begin(); face != faces.end();) faces.erase(face++);
    auto& vertices = tds().vertices();
    for (auto vertex = vertices.begin(); vertex != vertices.end();) vertices.erase(vertex++);
    tds().set_dimension(-2);
    set_infinite_vertex(tds().insert_first());
  }
};

Delaunay::Delaunay() : triangulation_(std::make_unique<Triangulation>()) {}
Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

void Delaunay::build(std::span<const Point> sites) {
  triangles_.clear();
  edges_.clear();
  try {
    Triangulation& t = *triangulation_;
    t.empty();
    Base::Face_handle near;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Base::Vertex_handle vertex = t.insert(Kernel::Point_2(sites[i].x, sites[i].y), near);
      vertex->info() = static_cast<int>(i);
      near = vertex->face();
    }
    if (t.dimension() == 2) {
      read_triangles(t);
    } else if (t.dimension() == 1) {
      for (auto edge = t.finite_edges_begin(); edge != t.finite_edges_end(); ++edge) {
        const auto& [face, opposite] = *edge;
        edges_.push_back(
            {face->vertex(t.ccw(opposite))->info(), face->vertex(t.cw(opposite))->info(), outside, outside});
      }
    }
  } catch (const CGAL::Failure_exception& failure) {
    triangulation_ = std::make_unique<Triangulation>();  // the old one may be half built
    throw std::runtime_error("Delaunay triangulation of " + std::to_string(sites.size()) +
                             " sites: CGAL refuses: " + failure.expression());
  }
}

void Delaunay::read_triangles(Triangulation& t) {
  // CGAL closes the plane with triangles to a vertex at infinity: these are `outside`.
  for (auto face = t.tds().faces_begin(); face != t.tds().faces_end(); ++face) {
    face->info() = t.is_infinite(face) ? outside : static_cast<int>(triangles_.size());
    if (face->info() == outside) continue;
    triangles_.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  for (auto face = t.tds().faces_begin(); face != t.tds().faces_end(); ++face) {
    const int left = face->info();
    if (left == outside) continue;
    for (int i = 0; i < 3; ++i) {  // every edge once: from the triangle with the larger number, or the only one
      const int right = face->neighbor(i)->info();
      if (right > left) continue;
      edges_.push_back({face->vertex(t.ccw(i))->info(), face->vertex(t.cw(i))->info(), left, right});
    }
  }
}

}  // namespace voronoi
