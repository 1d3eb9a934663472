# The build with catkin: finds what the stage `ros` needs, generates the messages, and says where catkin wants things.
# FOURWIS_ROS_DEFINITIONS, FOURWIS_ROS_INCLUDE_DIRS: what the stage `ros` is compiled with besides catkin_INCLUDE_DIRS.
find_package(catkin REQUIRED COMPONENTS
  actionlib
  diagnostic_updater
  geometry_msgs
  map_msgs
  message_filters
  message_generation
  move_base_msgs
  nav_msgs
  rosgraph_msgs
  roscpp
  sensor_msgs
  std_msgs
  std_srvs
  tf2
  tf2_geometry_msgs
  tf2_ros
  visualization_msgs)

file(GLOB message_files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/msg CONFIGURE_DEPENDS msg/*.msg)
file(GLOB service_files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/srv CONFIGURE_DEPENDS srv/*.srv)
add_message_files(FILES ${message_files})
add_service_files(FILES ${service_files})
generate_messages(DEPENDENCIES geometry_msgs nav_msgs std_msgs)

# The extras have the libraries, as targets, and these have the include path.
#catkin_lint: ignore missing_export_lib unused_include_path
catkin_package(
  INCLUDE_DIRS include
  CATKIN_DEPENDS actionlib diagnostic_updater geometry_msgs map_msgs message_filters message_runtime move_base_msgs
    nav_msgs rosgraph_msgs roscpp sensor_msgs std_msgs std_srvs tf2 tf2_geometry_msgs tf2_ros visualization_msgs
  DEPENDS Boost EIGEN3 IPOPT JPEG LEPTONICA OCTOMAP PNG YAML_CPP
  CFG_EXTRAS fourwis_navigation-extras.cmake)

# Catkin sets these for all targets of the folder. The stages other than `ros` are compiled as they are without
# ROS, so that one compiler cache serves both builds.
get_directory_property(FOURWIS_ROS_DEFINITIONS COMPILE_DEFINITIONS)
get_directory_property(FOURWIS_ROS_INCLUDE_DIRS INCLUDE_DIRECTORIES)
set_directory_properties(PROPERTIES COMPILE_DEFINITIONS "" INCLUDE_DIRECTORIES "")

set(FOURWIS_BIN_DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
set(FOURWIS_INCLUDE_DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
set(FOURWIS_LIB_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
set(FOURWIS_SHARE_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
set(FOURWIS_CMAKE_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/cmake)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")  # where Debian's catkin has its own file in that case
  set(FOURWIS_CMAKE_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}/cmake/${PROJECT_NAME})
endif()
set(FOURWIS_PACKAGE_DIR ${CATKIN_DEVEL_PREFIX}/share/${PROJECT_NAME}/cmake)
