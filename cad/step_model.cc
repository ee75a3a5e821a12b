#include "cad/step_model.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <utility>

#include "base/errors.h"

namespace geneva::cad {

namespace {

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  const TCollection_ExtendedString& text = name->Get();
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()), '\0');
  char* begin = utf8.data();
  text.ToUTF8CString(begin);
  return utf8;
}

/// Name that the file gives a face, wherever its part stands.
std::string name_of(const TopoDS_Shape& face, const Handle(XSControl_TransferReader) & made) {
  const TopoDS_Shape own = face.Located(TopLoc_Location());
  const auto item =
      Handle(StepRepr_RepresentationItem)::DownCast(made->EntityFromShapeResult(own, 1));
  return item.IsNull() || item->Name().IsNull() ? "" : item->Name()->ToCString();
}

void add_body(const TopoDS_Shape& shape, const std::string& name,
              const Handle(XSControl_TransferReader) & made, std::vector<StepBody>& bodies) {
  StepBody body{name, shape, {}};
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    body.faces.push_back({face.Current(), name_of(face.Current(), made)});
  bodies.push_back(std::move(body));
}

/// Solids of a part, and faces that are of none.
void add_part(const TDF_Label& part, const std::string& name, const TopLoc_Location& place,
              const Handle(XSControl_TransferReader) & made, std::vector<StepBody>& bodies) {
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part).Moved(place);
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    add_body(solid.Current(), name, made, bodies);
  for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next())
    add_body(face.Current(), name, made, bodies);
}

void add_label(const TDF_Label& label, const TopLoc_Location& place,
               const Handle(XSControl_TransferReader) & made, std::vector<StepBody>& bodies) {
  if (!XCAFDoc_ShapeTool::IsAssembly(label)) {
    add_part(label, name_of(label), place, made, bodies);
    return;
  }
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(label, components);
  for (const TDF_Label& component : components) {
    TDF_Label product;
    XCAFDoc_ShapeTool::GetReferredShape(component, product);
    add_label(product, place * XCAFDoc_ShapeTool::GetLocation(component), made, bodies);
  }
}

std::vector<StepBody> bodies_of(const std::filesystem::path& file) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // it writes to standard output
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    throw base::InputError(file.string() +
                           ": this is no STEP file that can be read: export the parts again as "
                           "STEP AP203, AP214 or AP242");
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  XCAFDoc_DocumentTool::SetLengthUnit(document, kernel_unit);
  if (!reader.Transfer(document))
    throw base::InputError(file.string() + ": the file has no shape that can be read");
  TDF_LabelSequence free;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(free);
  std::vector<StepBody> bodies;
  for (const TDF_Label& label : free)
    add_label(label, {}, reader.Reader().WS()->TransferReader(), bodies);
  if (bodies.empty())
    throw base::InputError(file.string() +
                           ": the file has no solid and no face: export the parts as solids, a "
                           "plane model as its plane faces");
  return bodies;
}

}  // namespace

std::vector<StepBody> read_step(const std::filesystem::path& file) {
  try {
    return bodies_of(file);
  } catch (const Standard_Failure& failure) {
    throw base::InputError(file.string() +
                           ": the CAD kernel cannot read this file: " + failure.GetMessageString());
  }
}

}  // namespace geneva::cad
