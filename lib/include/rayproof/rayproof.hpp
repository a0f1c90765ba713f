#pragma once
/// \file
/// The whole library: shapes and their methods, lists of objects, batches, cameras, and rays that leave a
/// surface.

#include <rayproof/batch.hpp>
#include <rayproof/camera.hpp>
#include <rayproof/nearest_hit.hpp>
#include <rayproof/object_list.hpp>
#include <rayproof/object_tree.hpp>
#include <rayproof/spawn.hpp>
#include <rayproof/topics.hpp>
