#include "map_description.h"

#include <yaml-cpp/yaml.h>

#include <cmath>

#include "input_file.h"

namespace fourwis
{
namespace
{

/// Access to the fields of one YAML file; a defect is reported with the field's name.
class Fields
{
public:
  explicit Fields(const InputFile& file) : file_(file), root_(parse(file))
  {
    if (!root_.IsMap()) file_.reject("format", "expected a YAML mapping with image, resolution, origin, ...");
  }

  double number(const char* name) const { return to_number(scalar(name), name); }

  Pose pose(const char* name) const
  {
    const YAML::Node node = required(name);
    if (!node.IsSequence() || node.size() != 3) file_.reject(name, "expected three numbers [x, y, yaw]");
    return {to_number(node[0], name), to_number(node[1], name), to_number(node[2], name)};
  }

  bool flag(const char* name) const
  {
    const YAML::Node node = scalar(name);
    bool value = node.Scalar() == "1";
    if (!value && node.Scalar() != "0" && !YAML::convert<bool>::decode(node, value))
      file_.reject(name, "expected 0, 1, true or false, got " + quoted(node.Scalar()));
    return value;
  }

  std::string text(const char* name) const
  {
    const YAML::Node node = scalar(name);
    if (node.Scalar().empty()) file_.reject(name, "expected a text, got an empty one");
    return node.Scalar();
  }

  bool has(const char* name) const { return static_cast<bool>(root_[name]); }

private:
  static YAML::Node parse(const InputFile& file)
  {
    try
    {
      return YAML::Load(file.bytes);
    }
    catch (const YAML::Exception& error)
    {
      file.reject("format", std::string("expected YAML: ") + error.what());
    }
  }

  YAML::Node required(const char* name) const
  {
    if (!has(name)) file_.reject(name, "missing, expected a value");
    return root_[name];
  }

  YAML::Node scalar(const char* name) const
  {
    const YAML::Node node = required(name);
    if (!node.IsScalar()) file_.reject(name, "expected a single value");
    return node;
  }

  double to_number(const YAML::Node& node, const char* name) const
  {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
      file_.reject(name, "expected a finite number, got " + (node.IsScalar() ? quoted(node.Scalar()) : "none"));
    return value;
  }

  const InputFile& file_;
  const YAML::Node root_;
};

double read_resolution(const InputFile& file, const Fields& fields)
{
  const double resolution = fields.number("resolution");
  if (resolution <= 0.0) file.reject("resolution", "expected a number above 0, got " + std::to_string(resolution));
  return resolution;
}

double read_threshold(const InputFile& file, const Fields& fields, const char* name)
{
  const double threshold = fields.number(name);
  if (threshold < 0.0 || threshold > 1.0) file.reject(name, "expected 0 to 1, got " + std::to_string(threshold));
  return threshold;
}

ValueMode read_mode(const InputFile& file, const Fields& fields)
{
  const std::string mode = fields.has("mode") ? fields.text("mode") : "trinary";
  if (mode == "trinary") return ValueMode::trinary;
  if (mode == "scale") return ValueMode::scale;
  if (mode == "raw") return ValueMode::raw;
  file.reject("mode", "expected trinary, scale or raw, got " + quoted(mode));
}

}  // namespace

MapDescription read_map_description(const std::string& path)
{
  // No map's description is longer; the parser recurses, so what it is given to nest is limited.
  constexpr std::size_t max_bytes = 8192;
  const InputFile file = read_input_file(path, max_bytes);
  const Fields fields(file);
  MapDescription map;
  map.image = fields.text("image");
  map.resolution = read_resolution(file, fields);
  map.origin = fields.pose("origin");
  map.negate = fields.flag("negate");
  map.occupied_thresh = read_threshold(file, fields, "occupied_thresh");
  map.free_thresh = read_threshold(file, fields, "free_thresh");
  map.mode = read_mode(file, fields);
  if (map.occupied_thresh < map.free_thresh)
    file.reject("occupied_thresh", "expected at least free_thresh " + std::to_string(map.free_thresh) + ", got " +
                                       std::to_string(map.occupied_thresh));
  return map;
}

}  // namespace fourwis
