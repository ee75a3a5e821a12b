#include "cad/step_file.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>
#include <utility>

#include "base/errors.h"
#include "base/output_file.h"
#include "cad/part_shape.h"
#include "cad/step_model.h"

namespace geneva::cad {

namespace {

void name(const TDF_Label& label, const std::string& text) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(text.c_str(), true));
}

gp_Trsf motion(const loads::Placement& placement) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0., 0., 0.), gp_Dir(0., 0., 1.)), placement.angle);
  gp_Trsf move;
  move.SetTranslation(
      gp_Vec(placement.origin.x / kernel_unit, placement.origin.y / kernel_unit, 0.));
  return move * turn;
}

/// Products by their names, with the names of their faces.
using Products = std::map<std::string, std::pair<TDF_Label, PartShape>>;

TDF_Label product(const Handle(XCAFDoc_ShapeTool) & tool, const loads::SolidPart& part,
                  Products& products) {
  const auto [found, is_new] = products.try_emplace(part.name);
  auto& [label, shape] = found->second;
  if (is_new) {
    shape = shape_of(part);
    label = tool->AddShape(shape.solid, false);
    name(label, part.name);
  }
  return label;
}

void add_assembly(const Handle(XCAFDoc_ShapeTool) & tool,
                  const std::vector<loads::SolidPart>& parts, const std::string& title,
                  Products& products) {
  const TDF_Label root = tool->NewShape();
  name(root, title);
  for (const loads::SolidPart& part : parts)
    name(tool->AddComponent(root, product(tool, part, products),
                            TopLoc_Location(motion(part.placement))),
         part.name);
  tool->UpdateAssemblies();
}

/// Names the faces that the writer has made.
void name_faces(const STEPCAFControl_Writer& writer, const Products& products) {
  const Handle(Transfer_FinderProcess) made =
      writer.Writer().WS()->TransferWriter()->FinderProcess();
  for (const auto& [name, product] : products)
    for (const NamedFace& face : product.second.faces) {
      const Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(made, face.face);
      if (!item.IsNull()) item->SetName(new TCollection_HAsciiString(face.name.c_str()));
    }
}

}  // namespace

void write_step(const std::filesystem::path& file, const std::vector<loads::SolidPart>& parts,
                const std::string& assembly, const FileUnit unit) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // it writes to standard output
  STEPCAFControl_Controller::Init();                      // without it there is no parameter to set
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", unit == FileUnit::inch ? "INCH" : "MM");
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  XCAFDoc_DocumentTool::SetLengthUnit(document, kernel_unit);
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  Products products;
  if (parts.size() == 1)
    product(tool, parts.front(), products);
  else
    add_assembly(tool, parts, assembly, products);
  STEPCAFControl_Writer writer;  // takes the parameters as they are now
  const auto refuse = [&] { throw base::InputError("cannot write " + file.string()); };
  if (!writer.Transfer(document, STEPControl_AsIs)) refuse();
  name_faces(writer, products);
  if (writer.Write(file.c_str()) != IFSelect_RetDone) refuse();
  base::synchronise(file);
}

std::vector<StepSolid> solids_of_step(const std::filesystem::path& file) {
  std::vector<StepSolid> solids;
  for (const StepBody& body : read_step(file)) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(body.shape, properties);
    constexpr double cubic_unit = kernel_unit * kernel_unit * kernel_unit;
    StepSolid solid{body.name, properties.Mass() * cubic_unit, {}};
    for (const NamedFace& face : body.faces)
      if (!face.name.empty()) solid.faces.push_back(face.name);
    solids.push_back(std::move(solid));
  }
  return solids;
}

}  // namespace geneva::cad
