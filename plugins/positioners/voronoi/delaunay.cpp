// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL (it takes 12 s to compile).
#include "delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

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
    erase_all();
    tds().set_dimension(-2);
    set_infinite_vertex(tds().insert_first());
  }

  // The triangle of three sites that are not on one line, alone; the last two of its vertices. CGAL's own way there,
  // point by point, allocates.
  std::pair<Vertex_handle, Vertex_handle> begin(const Point& a, const Point& b, const Point& c) {
    erase_all();
    tds().set_dimension(2);
    const Vertex_handle outer = tds().create_vertex();
    set_infinite_vertex(outer);
    std::array<Vertex_handle, 3> corner;
    for (auto& vertex : corner) vertex = tds().create_vertex();
    corner[0]->set_point(a);
    const bool left = orientation(a, b, c) == CGAL::LEFT_TURN;
    corner[1]->set_point(left ? b : c);
    corner[2]->set_point(left ? c : b);
    const Face_handle inner = tds().create_face(corner[0], corner[1], corner[2]);
    std::array<Face_handle, 3> beyond;  // the side opposite to corner k
    for (std::size_t k = 0; k < 3; ++k) {
      beyond[k] = tds().create_face(corner[(k + 2) % 3], corner[(k + 1) % 3], outer);
      tds().set_adjacency(inner, static_cast<int>(k), beyond[k], 2);
      corner[k]->set_face(inner);
    }
    for (std::size_t k = 0; k < 3; ++k) tds().set_adjacency(beyond[k], 1, beyond[(k + 1) % 3], 0);
    corner[0]->info() = 0;
    outer->set_face(beyond[0]);  // the side from b to c
    return {corner[left ? 1 : 2], corner[left ? 2 : 1]};
  }

  // Makes the infinite vertex stand on a side of the hull at `vertex`, which is on the hull.
  void turn_to(Vertex_handle vertex) {
    Face_handle side = vertex->face();
    while (!side->has_vertex(infinite_vertex())) side = side->neighbor(ccw(side->index(vertex)));
    infinite_vertex()->set_face(side);
  }

  // Inserts a point that comes after all others in the order of x, then y. It is outside of the hull and sees a side of
  // `last`, the one before it, so that nothing has to be searched; otherwise this is CGAL's insertion of such a point,
  // without the lists that it allocates.
  Vertex_handle append(const Point& point, Vertex_handle last) {
    const Vertex_handle outer = infinite_vertex();
    const Face_handle start = seen_side(point, last);
    if (start == Face_handle()) return insert(point, last->face());
    clockwise_.clear();
    counter_clockwise_.clear();
    for (Face_handle f = start->neighbor(cw(start->index(outer))); sees(point, f);
         f = f->neighbor(cw(f->index(outer)))) {
      counter_clockwise_.push_back(f);
    }
    for (Face_handle f = start->neighbor(ccw(start->index(outer))); sees(point, f);
         f = f->neighbor(ccw(f->index(outer)))) {
      clockwise_.push_back(f);
    }
    const Vertex_handle vertex = tds().insert_in_face(start);
    vertex->set_point(point);
    for (const Face_handle f : counter_clockwise_) tds().flip(f, ccw(f->index(outer)));
    for (const Face_handle f : clockwise_) tds().flip(f, cw(f->index(outer)));
    turn_to(vertex);
    restore_Delaunay(vertex);
    return vertex;
  }

 private:
  void erase_all() {
    auto& faces = tds().faces();
    for (auto face = faces.begin(); face != faces.end();) faces.erase(face++);
    auto& vertices = tds().vertices();
    for (auto vertex = vertices.begin(); vertex != vertices.end();) vertices.erase(vertex++);
  }

  // Whether the point is strictly beyond the side of the hull that this infinite face stands on.
  bool sees(const Point& point, Face_handle face) const {
    const int i = face->index(infinite_vertex());
    return orientation(point, face->vertex(ccw(i))->point(), face->vertex(cw(i))->point()) == CGAL::LEFT_TURN;
  }

  // One of the two sides of the hull at `last`; the null handle when none of them is seen.
  Face_handle seen_side(const Point& point, Vertex_handle last) const {
    const Face_handle first = infinite_vertex()->face();
    if (!first->has_vertex(last)) return {};
    if (sees(point, first)) return first;
    const int i = first->index(infinite_vertex());
    for (const Face_handle other : {first->neighbor(ccw(i)), first->neighbor(cw(i))}) {
      if (other->has_vertex(last) && sees(point, other)) return other;
    }
    return {};
  }

  std::vector<Face_handle> clockwise_, counter_clockwise_;  // sides that a new point sees, from the first one on

 public:
  Triangulation() {
    clockwise_.reserve(64);
    counter_clockwise_.reserve(64);
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
    const auto point = [&sites](std::size_t i) { return Kernel::Point_2(sites[i].x, sites[i].y); };
    std::size_t i = 0;
    Base::Vertex_handle last;
    // As many as the first ones on one line ascend on it, and the first one beside it.
    std::size_t beside = 2;
    const auto follows = [&](std::size_t k) { return sites[k - 1] < sites[k]; };
    if (sites.size() >= 3 && follows(1)) {
      while (beside < sites.size() && follows(beside) &&
             CGAL::orientation(point(0), point(1), point(beside)) == CGAL::COLLINEAR) {
        ++beside;
      }
    }
    if (beside < sites.size() && CGAL::orientation(point(0), point(1), point(beside)) != CGAL::COLLINEAR) {
      Base::Vertex_handle on_line;
      std::tie(on_line, last) = t.begin(point(0), point(1), point(beside));
      on_line->info() = 1;
      last->info() = static_cast<int>(beside);
      for (i = 2; i < beside; ++i) {
        t.turn_to(on_line);
        on_line = t.append(point(i), on_line);
        on_line->info() = static_cast<int>(i);
      }
      t.turn_to(last);
      i = beside + 1;
    } else {
      t.empty();
    }
    bool ascending = i == 0 || (follows(1) && follows(beside));
    for (; i < sites.size(); ++i) {
      ascending = ascending && (i == 0 || sites[i - 1] < sites[i]);
      if (ascending && t.dimension() == 2) {
        last = t.append(point(i), last);
      } else {
        last = t.insert(point(i), last == Base::Vertex_handle() ? Base::Face_handle() : last->face());
      }
      last->info() = static_cast<int>(i);
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
