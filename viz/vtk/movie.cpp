#include "viz/vtk/movie.hpp"

#include <vtkOggTheoraWriter.h>

#include <stdexcept>

#include "viz/vtk/image_of.hpp"

namespace rayproof::viz {

Movie::Movie(const std::string& path, int rate) : path_(path), writer_(vtkOggTheoraWriter::New()) {
  writer_->SetFileName(path.c_str());
  writer_->SetRate(rate);
  writer_->SetQuality(2);
  writer_->SubsamplingOff();  // coloured letters stay sharp
}

Movie::~Movie() {
  if (is_begun_) writer_->End();
  writer_->Delete();
}

void Movie::add(const Raster& picture, int count) {
  writer_->SetInputData(image_of(picture));
  if (!is_begun_) writer_->Start();
  is_begun_ = true;
  for (int i = 0; i < count; ++i) writer_->Write();
  if (writer_->GetError() != 0) throw std::runtime_error("the film " + path_ + " can't be written");
}

}  // namespace rayproof::viz
