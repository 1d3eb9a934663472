#include "fourwis_navigation/map/map_file.h"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <locale>
#include <numeric>
#include <sstream>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/home_path.h"
#include "fourwis_navigation/model/sentence.h"
#include "image.h"
#include "input_file.h"
#include "map_description.h"

namespace fourwis
{
namespace
{

Image read_image_of(const MapDescription& map, const std::string& yaml_path)
{
  const std::filesystem::path folder = std::filesystem::path(yaml_path).parent_path();
  try
  {
    return read_image((folder / expand_home(map.image)).string());
  }
  catch (const MapFileError& error)
  {
    reject_file(yaml_path, "image", error.what());
  }
}

/// The grey with which map savers write cells that no sensor has seen.
constexpr int kUnseenGrey = 205;

/// What a threshold above that grey means: nav2 and slam_toolbox write 0.25 beside it.
std::string opening_sentence(const std::string& yaml_path, const MapDescription& map, const Image& image,
                             long long opened)
{
  return sentence(
      "%s: free_thresh is %g, so what map savers write for unseen (grey %d, occupied with %.4f) becomes free: %lld of "
      "%lld pixels; expected at most 0.196 where these shall stay unknown",
      yaml_path.c_str(), map.free_thresh, kUnseenGrey, (255 - kUnseenGrey) / 255.0, opened,
      static_cast<long long>(image.width) * image.height);
}

/// map_server's value of a pixel whose colour samples have the mean `colour` in 0..255.
std::int8_t cell_value(const MapDescription& map, double colour, bool is_opaque)
{
  const double brightness = map.negate ? 255.0 - colour : colour;
  if (map.mode == ValueMode::raw) return static_cast<std::int8_t>(static_cast<std::uint8_t>(brightness));
  if (!is_opaque) return -1;
  const double occupied = (255.0 - brightness) / 255.0;
  if (occupied > map.occupied_thresh) return 100;
  if (occupied < map.free_thresh) return 0;
  const double span = map.occupied_thresh - map.free_thresh;
  if (map.mode == ValueMode::trinary || span <= 0.0) return -1;
  return static_cast<std::int8_t>(1.0 + 98.0 * (occupied - map.free_thresh) / span);
}

}  // namespace

OccupancyGrid read_map_file(const std::string& path, std::string* warning)
{
  const std::string yaml_path = expand_home(path);
  const MapDescription map = read_map_description(yaml_path);
  const Image image = read_image_of(map, yaml_path);
  long long opened = 0;
  OccupancyGrid grid{image.width, image.height, map.resolution, map.origin, {}};
  grid.data.reserve(image.samples.size() / static_cast<std::size_t>(image.channels()));
  for (int row = image.height - 1; row >= 0; --row)  // the image's lowest row is the grid's row 0
  {
    for (int column = 0; column < image.width; ++column)
    {
      const std::uint8_t* pixel = image.pixel(column, row);
      const double mean = std::accumulate(pixel, pixel + image.colours, 0) / static_cast<double>(image.colours);
      grid.data.push_back(cell_value(map, mean, !image.has_alpha || pixel[image.colours] == 255));
      if (mean == kUnseenGrey && !map.negate && grid.data.back() == 0) ++opened;
    }
  }
  if (warning && opened > 0) *warning = opening_sentence(yaml_path, map, image, opened);
  return grid;
}

namespace
{

/// The grey levels that map_server's own writer uses.
char grey(std::int8_t cell)
{
  if (cell < 0 || cell > 100) return static_cast<char>(kUnseenGrey);
  return static_cast<char>(ObstacleRule{}.is_obstacle(cell) ? 0 : 254);
}

void write_pgm(const OccupancyGrid& grid, std::ostream& out)
{
  out << "P5\n" << grid.width << ' ' << grid.height << "\n255\n";
  for (int row = grid.height - 1; row >= 0; --row)
  {
    for (int column = 0; column < grid.width; ++column) out.put(grey(grid.at(column, row)));
  }
}

/// The shortest decimal text that reads back as the same number.
std::string decimal(double value)
{
  std::string text;
  for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits)
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(digits) << value;
    text = out.str();
    double back = 0.0;
    if (YAML::convert<double>::decode(YAML::Node(text), back) && back == value) break;
  }
  return text;
}

void write_yaml(const OccupancyGrid& grid, const std::string& image, std::ostream& out)
{
  YAML::Emitter quoted_image;
  quoted_image << YAML::DoubleQuoted << image;
  out << "image: " << quoted_image.c_str() << '\n'
      << "resolution: " << decimal(grid.resolution) << '\n'
      << "origin: [" << decimal(grid.origin.x) << ", " << decimal(grid.origin.y) << ", " << decimal(grid.origin.theta)
      << "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

template <typename Write>
void write_file(const std::string& path, const Write& write)
{
  std::ofstream out(path, std::ios::binary);
  if (out) write(out);
  out.close();
  if (!out) reject_file(path, "file", "expected a writable file");
}

}  // namespace

void write_map_file(const OccupancyGrid& grid, const std::string& stem)
{
  try
  {
    check_grid(grid);
  }
  catch (const std::invalid_argument& error)
  {
    reject_file(stem, "grid", error.what());
  }
  const std::string image = stem + ".pgm";
  write_file(image, [&](std::ostream& out) { write_pgm(grid, out); });
  write_file(stem + ".yaml",
             [&](std::ostream& out) { write_yaml(grid, std::filesystem::path(image).filename().string(), out); });
}

}  // namespace fourwis
