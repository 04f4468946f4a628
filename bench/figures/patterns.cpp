// What every map makes of a pattern of the unit square: the pictures of [GUK17], Figure 1, and [UFK13], Figure 5, as
// numbers. Writes points.csv, lines.csv and continuity.csv into the directory given.
//
// Continuity is told by the distances that the neighbours in a regular lattice of n² points end up at, as angles: the
// largest over the median. When n grows fourfold it stays as it is for a map with bounded derivatives, doubles where
// the map goes like a square root (the centre of a polar map), grows by 4^(2/3) where it goes like a cube root (the
// ends of the parallel map's slices), and grows fourfold where the map tears neighbours apart.
#include <hatbox/hatbox.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace hatbox;

struct Square {
  std::vector<float> u, v;

  void add(double new_u, double new_v) {
    u.push_back(static_cast<float>(new_u));
    v.push_back(static_cast<float>(new_v));
  }
  std::size_t size() const { return u.size(); }
};

struct Images {
  explicit Images(std::size_t n) : x(n), y(n), z(n), distance(n), pdf(n) {}
  std::vector<float> x, y, z, distance, pdf;
};

struct Pattern {
  std::string light, map;
  Vec3 point;
  std::function<void(Points, Variates, Samples)> sample;

  Images of(const Square& square) const {
    Images to(square.size());
    sample({{&point.x, 1}, {&point.y, 1}, {&point.z, 1}}, {square.u, square.v},
           {to.x, to.y, to.z, to.distance, to.pdf});
    return to;
  }
};

// All lights lie in the plane z = 0 and are seen from nearby and aside, where maps differ.
constexpr Disk disk{{0, 0, 0}, {0, 0, 1}, 1};
constexpr Ellipse ellipse{{0, 0, 0}, {1.3f, 0, 0}, {0, 0.6f, 0}};
constexpr Rectangle rectangle{{-1.2f, -0.8f, 0}, {2.4f, 0, 0}, {0, 1.6f, 0}};
constexpr Triangle triangle{{-1.1f, -0.8f, 0}, {1.2f, -0.7f, 0}, {-0.1f, 1.1f, 0}};
constexpr Vec3 from{0.7f, -0.5f, 0.45f};

template <class Light, class Map>
Pattern pattern(const char* name, const char* map_name, const Light& light, Map map) {
  return {name, map_name, from, [=](const Points& points, const Variates& variates, const Samples& out) {
            sample(light, map, points, variates, out);
          }};
}

std::vector<Pattern> patterns() {
  return {pattern("disk", "area", disk, DiskMap::area),
          pattern("disk", "rejection", disk, DiskMap::rejection),
          pattern("disk", "parallel", disk, DiskMap::parallel),
          pattern("disk", "radial", disk, DiskMap::radial),
          pattern("disk", "ld_radial", disk, DiskMap::ld_radial),
          pattern("disk", "parallel_carlson", disk, DiskMap::parallel_carlson),
          pattern("disk", "radial_carlson", disk, DiskMap::radial_carlson),
          pattern("disk", "table_radial", disk, DiskTable(DiskMap::radial)),
          pattern("disk", "table_ld_radial", disk, DiskTable(DiskMap::ld_radial)),
          pattern("ellipse", "area", ellipse, EllipseMap::area),
          pattern("ellipse", "radial", ellipse, EllipseMap::radial),
          pattern("ellipse", "ld_radial", ellipse, EllipseMap::ld_radial),
          pattern("rectangle", "area", rectangle, RectangleMap::area),
          pattern("rectangle", "two_triangles", rectangle, RectangleMap::two_triangles),
          pattern("rectangle", "spherical", rectangle, RectangleMap::spherical),
          pattern("triangle", "area", triangle, TriangleMap::area),
          pattern("triangle", "spherical", triangle, TriangleMap::spherical)};
}

/// One point in each of n² cells: in its middle, or anywhere.
Square lattice(int n, std::mt19937* jitter = nullptr) {
  Square square;
  std::uniform_real_distribution<double> anywhere;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double right = jitter ? anywhere(*jitter) : 0.5, up = jitter ? anywhere(*jitter) : 0.5;
      square.add((column + right) / n, (row + up) / n);
    }
  }
  return square;
}

Square hammersley(unsigned n) {
  Square square;
  for (unsigned i = 0; i < n; ++i) {
    double radical_inverse = 0, digit = 0.5;
    for (unsigned rest = i; rest != 0; rest >>= 1, digit /= 2) radical_inverse += (rest & 1) * digit;
    square.add((i + 0.5) / n, radical_inverse + 0.5 / n);
  }
  return square;
}

/// n + 1 lines each way, one after the other. Their points crowd at the ends, where maps may go like a cube root.
Square grid_lines(int n, int points_per_line) {
  Square square;
  for (const bool along_u : {false, true}) {
    for (int line = 0; line <= n; ++line) {
      for (int i = 0; i < points_per_line; ++i) {
        const double t = i / (points_per_line - 1.0), moving = t * t * t * (10 - 15 * t + 6 * t * t);
        const double fixed = static_cast<double>(line) / n;
        square.add(along_u ? moving : fixed, along_u ? fixed : moving);
      }
    }
  }
  return square;
}

void write_rows(std::ofstream& file, const Pattern& pattern, const std::string& set, const Square& square) {
  const Images to = pattern.of(square);
  char row[256];
  for (std::size_t i = 0; i < square.size(); ++i) {
    const auto number = [](float value) { return static_cast<double>(value); };
    std::snprintf(row, sizeof row, "%s,%s,%s,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g\n", pattern.light.c_str(),
                  pattern.map.c_str(), set.c_str(), number(square.u[i]), number(square.v[i]), number(to.x[i]),
                  number(to.y[i]), number(to.z[i]), number(from.x + to.distance[i] * to.x[i]),
                  number(from.y + to.distance[i] * to.y[i]));
    file << row;
  }
}

/// The largest distance of neighbours over …
struct Continuity {
  double largest_over_median;  // … the median
  double largest_over_ideal;   // … √Ω/n, the side of a square cell
};

Continuity continuity(const Pattern& pattern, int n) {
  const Images to = pattern.of(lattice(n));
  const auto angle = [&](std::size_t i, std::size_t j) {
    const double x = double{to.x[i]} - double{to.x[j]}, y = double{to.y[i]} - double{to.y[j]},
                 z = double{to.z[i]} - double{to.z[j]};
    return 2 * std::asin(std::min(1.0, std::sqrt(x * x + y * y + z * z) / 2));
  };
  std::vector<double> steps;
  const auto width = static_cast<std::size_t>(n);
  for (std::size_t i = 0; i < width * width; ++i) {
    if (i % width + 1 < width) steps.push_back(angle(i, i + 1));
    if (i + width < width * width) steps.push_back(angle(i, i + width));
  }
  const double largest = *std::max_element(steps.begin(), steps.end());
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  // The mean of 1/pdf over samples is the solid angle, whatever the map.
  const double solid_angle =
      std::accumulate(to.pdf.begin(), to.pdf.end(), 0.0,
                      [](double sum, float pdf) { return sum + (pdf > 0 ? 1 / double{pdf} : 0); }) /
      static_cast<double>(to.pdf.size());
  return {largest / *middle, largest * n / std::sqrt(solid_angle)};
}

std::ofstream open(const std::filesystem::path& path, const char* header) {
  std::ofstream file(path);
  if (!(file << header << '\n')) throw std::runtime_error("cannot write " + path.string());
  return file;
}

void write(const std::filesystem::path& out) {
  std::filesystem::create_directories(out);
  auto points = open(out / "points.csv", "light,map,set,u,v,x,y,z,s,t");
  auto lines = open(out / "lines.csv", "light,map,set,u,v,x,y,z,s,t");
  auto numbers = open(out / "continuity.csv", "light,map,n,largest_over_median,largest_over_ideal");
  for (const Pattern& pattern : patterns()) {
    std::mt19937 random(1);
    write_rows(points, pattern, "stratified", lattice(32, &random));
    write_rows(points, pattern, "hammersley", hammersley(256));
    write_rows(lines, pattern, "lines", grid_lines(8, 129));
    for (const int n : {128, 512}) {
      const Continuity c = continuity(pattern, n);
      numbers << pattern.light << ',' << pattern.map << ',' << n << ',' << c.largest_over_median << ','
              << c.largest_over_ideal << '\n';
    }
  }
  for (std::ofstream* file : {&points, &lines, &numbers})
    if (!file->flush()) throw std::runtime_error("cannot write into " + out.string());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("usage: figure_patterns DIRECTORY");
    write(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figure_patterns: %s\n", error.what());
    return 1;
  }
}
