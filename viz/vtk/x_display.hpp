#pragma once
/// \file
/// The user's X display, as far as VTK leaves it to its caller. Apart, since X's header defines macros of
/// common names.

class vtkRenderWindowInteractor;

namespace rayproof::viz {

/// Throws NoDisplay (viz/vtk/offscreen_display.hpp) with one sentence where DISPLAY can't show a window of
/// VTK's: VTK itself would abort the process.
void require_display();

/// Hands an initialized interactor of VTK's all events that have come for its window.
void dispatch_events(vtkRenderWindowInteractor& interactor);

/// Sleeps until an event has come for the interactor's window, or for so long.
void wait_for_events(vtkRenderWindowInteractor& interactor, int milliseconds);

}  // namespace rayproof::viz
