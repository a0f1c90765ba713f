#pragma once
/// \file
/// The mouse beside all widgets.

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>

namespace rayproof::viz {

/// VTK's trackball camera without its keys; a drawing in a plane is shifted where a scene in space is turned.
class OrbitStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static OrbitStyle* New() { VTK_STANDARD_NEW_BODY(OrbitStyle); }
  bool is_flat = false;

  void OnChar() override {}
  void Rotate() override { is_flat ? Pan() : vtkInteractorStyleTrackballCamera::Rotate(); }
  void Spin() override { is_flat ? Pan() : vtkInteractorStyleTrackballCamera::Spin(); }
};

}  // namespace rayproof::viz
