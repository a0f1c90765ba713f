#include "viz/vtk/space/triad.hpp"

#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkTextProperty.h>

namespace rayproof::viz {

Triad::Triad() {
  vtkNew<vtkAxesActor> axes;
  axes->SetXAxisLabelText("x");
  axes->SetYAxisLabelText("y");
  axes->SetZAxisLabelText("z");
  axes->SetNormalizedLabelPosition(1.3, 1.3, 1.3);
  for (vtkCaptionActor2D* const caption :
       {axes->GetXAxisCaptionActor2D(), axes->GetYAxisCaptionActor2D(), axes->GetZAxisCaptionActor2D()}) {
    vtkTextProperty& text = *caption->GetCaptionTextProperty();
    text.ItalicOff();
    text.ShadowOff();
    text.SetColor(0.1, 0.1, 0.1);
    caption->SetWidth(0.3);
    caption->SetHeight(0.2);
  }
  renderer_->AddActor(axes);
  renderer_->SetInteractive(0);
}

void Triad::show(vtkRenderer& space, bool is_shown) {
  renderer_->SetDraw(is_shown ? 1 : 0);
  vtkCamera& camera = *renderer_->GetActiveCamera();
  camera.SetParallelProjection(1);
  camera.SetParallelScale(1.55);
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(space.GetActiveCamera()->GetViewPlaneNormal());
  camera.SetViewUp(space.GetActiveCamera()->GetViewUp());
  camera.SetClippingRange(-3, 3);
}

}  // namespace rayproof::viz
