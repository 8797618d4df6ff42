// SPDX-License-Identifier: MIT
// The readers of the two formats. Internal to sim/import; see import.h.
#pragma once

#include "sim/import/import.h"
#include "sim/import/robot.h"
#include "sim/import/robot_meshes.h"
#include "sim/import/xml.h"

namespace pabd {

// `root` is <robot> of a URDF file. Throws Error(bad_input) with file and line.
Robot read_urdf(const XmlElement& root, RobotMeshes& meshes, ImportNotes& notes,
                const ImportOptions& options);

// `root` is <mujoco>; `files` reads what it includes. Throws as read_urdf does.
Robot read_mjcf(const XmlElement& root, XmlFiles& files, RobotMeshes& meshes, ImportNotes& notes,
                const ImportOptions& options);

}  // namespace pabd
