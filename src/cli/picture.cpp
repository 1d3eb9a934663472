#include "picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "cell_rectangles.h"
#include "fourwis_navigation/corridor/polytope_corridor.h"
#include "fourwis_navigation/model/mode_colour.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "fourwis_navigation/vehicle/body.h"
#include "legend.h"
#include "motion_samples.h"
#include "page.h"

namespace fourwis
{
namespace
{

/// Footprints are drawn this often, in body lengths (no simple fraction, so that front and rear edges do not fall together) and
/// in radians.
constexpr double kFootprintSpacing = 0.35, kFootprintTurn = 0.3;

/// A corner of a cell in the map frame.
Point corner(const OccupancyGrid& grid, int column, int row)
{
  return at_pose(grid.origin, column * grid.resolution, row * grid.resolution);
}

/// Of the body with C, the centre of the wheels, at a pose.
std::vector<Point> body_corners(const Robot& robot, const Pose& pose)
{
  std::vector<Point> corners;
  for (const Point2& corner : body_of(robot)) corners.push_back(at_pose(pose, corner.x, corner.y));
  return corners;
}

/// The known part of the map and the whole trajectory.
ShownArea extent_of(const PlanPicture& picture, const std::vector<ModeRun>& runs)
{
  ShownArea extent;
  const CellRectangle known = known_block(picture.grid);
  for (const int column : {known.left, known.right})
    for (const int row : {known.bottom, known.top}) extent.include(corner(picture.grid, column, row));
  for (const ModeRun& run : runs)
    for (const Pose& pose : run.poses)
      for (const Point& point : body_corners(picture.robot, pose)) extent.include(point);
  return extent;
}

void write_cells(std::ostream& out, const char* colour, const std::vector<CellRectangle>& rectangles)
{
  if (rectangles.empty()) return;
  out << "<path fill=\"" << colour << "\" d=\"";
  for (const CellRectangle& r : rectangles)
    out << 'M' << r.left << ',' << r.bottom << 'h' << r.right - r.left << 'v' << r.top - r.bottom << 'h'
        << r.left - r.right << 'z';
  out << "\"/>\n";
}

/// Cells are drawn in units of cells; the group's matrix brings them to the page.
void write_map(std::ostream& out, const Page& page, const PlanPicture& picture)
{
  const OccupancyGrid& grid = picture.grid;
  const Point origin = page.to_page({grid.origin.x, grid.origin.y});
  const double side = grid.resolution * page.scale;
  const double c = side * std::cos(grid.origin.theta), s = side * std::sin(grid.origin.theta);
  out << "<g transform=\"matrix(" << c << ' ' << -s << ' ' << -s << ' ' << -c << ' ' << origin.x << ' ' << origin.y
      << ")\" shape-rendering=\"crispEdges\">\n";
  write_cells(out, kFreeColour, {{0, 0, grid.width, grid.height}});
  const auto is_unknown = [](std::int8_t cell) { return cell < 0 || cell > 100; };
  write_cells(out, kUnknownColour, cell_rectangles(grid, is_unknown));
  const int threshold = picture.rule.occupied_threshold;
  write_cells(out, kOccupiedColour,
              cell_rectangles(grid, [&](std::int8_t cell) { return !is_unknown(cell) && cell >= threshold; }));
  out << "</g>\n";
}

/// The regions of one disc as one shape, so that they do not darken where they overlap, each with its outline.
void write_regions(std::ostream& out, const Page& page, const PlanPicture& picture, std::size_t disc)
{
  const ShownArea& shown = page.extent;
  const Point2 middle{(shown.min_x + shown.max_x) / 2.0, (shown.min_y + shown.max_y) / 2.0};
  const double reach = std::max(shown.max_x - shown.min_x, shown.max_y - shown.min_y);
  out << "<path class=\"corridor disc" << disc << "\" d=\"";
  for (const Corridor& corridor : picture.corridors)
  {
    if (disc >= corridor.size()) continue;
    for (const Polytope& polytope : corridor[disc].regions)
    {
      std::vector<Point> polygon;
      for (const Point2& corner : corners(polytope, middle, reach)) polygon.push_back({corner.x, corner.y});
      out << polyline(page, polygon, true);
    }
  }
  out << "\" fill=\"" << kCorridorColour << "\" fill-opacity=\"0.10\" stroke=\"" << kCorridorColour
      << "\" stroke-opacity=\"0.25\" stroke-width=\"0.5\"/>\n";
}

void write_corridors(std::ostream& out, const Page& page, const PlanPicture& picture)
{
  std::size_t discs = 0;
  for (const Corridor& corridor : picture.corridors) discs = std::max(discs, corridor.size());
  for (std::size_t disc = 0; disc < discs; ++disc) write_regions(out, page, picture, disc);
}

void write_iterations(std::ostream& out, const Page& page, const PlanPicture& picture)
{
  double darkness = 0.0;
  for (const Trajectory& iteration : picture.iterations)
  {
    std::vector<Point> points;
    for (const TrajectoryPoint& point : BaseLink(picture.robot).to_centre(iteration))
      points.push_back({point.x, point.y});
    darkness += 0.9 / static_cast<double>(picture.iterations.size());
    out << "<path class=\"iteration\" d=\"" << polyline(page, points, false) << "\" fill=\"none\" stroke=\""
        << kIterationColour << "\" stroke-opacity=\"" << darkness << "\" stroke-width=\"1\"/>\n";
  }
}

void write_footprints(std::ostream& out, const Page& page, const Robot& robot, const ModeRun& run)
{
  out << "<path class=\"footprints " << to_string(run.mode) << "\" d=\"";
  for (const Pose& pose : thin_out(run.poses, kFootprintSpacing * robot.body_length(), kFootprintTurn))
    out << polyline(page, body_corners(robot, pose), true);
  const std::string colour = svg_colour(run.mode);
  out << "\" fill=\"" << colour << "\" fill-opacity=\"0.10\" stroke=\"" << colour
      << "\" stroke-opacity=\"0.55\" stroke-width=\"0.8\"/>\n";
}

void write_centre_line(std::ostream& out, const Page& page, const ModeRun& run)
{
  std::vector<Point> points;
  for (const Pose& pose : run.poses) points.push_back({pose.x, pose.y});
  out << "<path class=\"centre " << to_string(run.mode) << "\" d=\"" << polyline(page, points, false)
      << "\" fill=\"none\" stroke=\"" << svg_colour(run.mode)
      << "\" stroke-width=\"3\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n";
}

void write_switch(std::ostream& out, const Page& page, const Pose& pose)
{
  const Point centre = page.to_page({pose.x, pose.y});
  out << "<circle class=\"switch\" cx=\"" << pixels(centre.x) << "\" cy=\"" << pixels(centre.y)
      << "\" r=\"4.5\" fill=\"#ffffff\" stroke=\"" << kStartColour << "\" stroke-width=\"2\"/>\n";
}

/// The body at a pose with an arrow along its heading, large enough to be seen on a map of any size.
void write_marker(std::ostream& out, const Page& page, const Robot& robot, const Pose& pose, const char* name,
                  const char* colour)
{
  const double a = std::max(0.36 * robot.body_length(), 7.0 / page.scale), b = 0.6 * a;
  const std::vector<Point> arrow = {at_pose(pose, a, 0.0), at_pose(pose, -a, b), at_pose(pose, -0.45 * a, 0.0),
                                    at_pose(pose, -a, -b)};
  const std::string body = polyline(page, body_corners(robot, pose), true);
  // White below, so that it can be seen on obstacles, too.
  out << "<g class=\"" << name << "\" stroke-linejoin=\"round\">\n"
      << "<path d=\"" << body << "\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"4\"/>\n"
      << "<path d=\"" << body << "\" fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"2\"/>\n"
      << "<path d=\"" << polyline(page, arrow, true) << "\" fill=\"" << colour
      << "\" stroke=\"#ffffff\" stroke-width=\"0.8\"/>\n</g>\n";
}

void write_plan(std::ostream& out, const Page& page, const PlanPicture& picture, const std::vector<ModeRun>& runs)
{
  for (const ModeRun& run : runs) write_footprints(out, page, picture.robot, run);
  const BaseLink base_link(picture.robot);
  write_marker(out, page, picture.robot, base_link.to_centre(picture.start), "start", kStartColour);
  write_marker(out, page, picture.robot, base_link.to_centre(picture.goal), "goal", kGoalColour);
  for (const ModeRun& run : runs) write_centre_line(out, page, run);
  for (std::size_t i = 1; i < runs.size(); ++i) write_switch(out, page, runs[i].poses.front());
}

}  // namespace

std::string svg_colour(Mode mode)
{
  const Colour& colour = colour_of(mode);
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text;
}

void write_svg(std::ostream& out, const PlanPicture& picture)
{
  const double finest = picture.grid.resolution / 2.0;
  const std::vector<ModeRun> runs =
      sample_motion(picture.robot, BaseLink(picture.robot).to_centre(picture.result.trajectory), finest);
  const Page page(extent_of(picture, runs));
  const std::string width = pixels(page.width), height = pixels(page.height);

  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height << "\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"#f4f5f7\"/>\n"
      << "<clipPath id=\"map\"><rect x=\"" << pixels(page.left) << "\" y=\"0\" width=\"" << pixels(page.map_width)
      << "\" height=\"" << pixels(page.map_height) << "\"/></clipPath>\n"
      << "<g clip-path=\"url(#map)\">\n";
  out << "<rect width=\"" << width << "\" height=\"" << pixels(page.map_height) << "\" fill=\"" << kUnknownColour
      << "\"/>\n";
  write_map(out, page, picture);
  write_corridors(out, page, picture);
  write_plan(out, page, picture, runs);
  write_iterations(out, page, picture);
  out << "</g>\n";
  write_legend(out, page, picture);
  out << "</svg>\n";
}

}  // namespace fourwis
