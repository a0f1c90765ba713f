#pragma once
/// \file
/// What the file of a method is written with: its contract, its source, and the steps that it narrates.

#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/method/sources.hpp>
