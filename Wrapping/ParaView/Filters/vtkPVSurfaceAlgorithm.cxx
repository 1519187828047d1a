// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVSurfaceAlgorithm.h"

#include "BlockTree.h"
#include "FilterExecution.h"
#include "MessageText.h"
#include "OptionTable.h"
#include "RankExchange.h"
#include "TextNumbers.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObjectTypes.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// What the input's blocks are kept in; null if they are not kept.
const char* treeClassOf(vtkDataObject* input)
{
  return vtkMultiBlockDataSet::SafeDownCast(input)         ? "vtkMultiBlockDataSet"
    : vtkPartitionedDataSetCollection::SafeDownCast(input) ? "vtkPartitionedDataSetCollection"
                                                           : nullptr;
}

/// Appends a collection's members, their names behind a block's.
void append(vtkPartitionedDataSetCollection* members, const std::string& block,
  vtkPartitionedDataSetCollection* all)
{
  for (unsigned int i = 0; i < members->GetNumberOfPartitionedDataSets(); ++i)
  {
    const unsigned int at = all->GetNumberOfPartitionedDataSets();
    all->SetPartitionedDataSet(at, members->GetPartitionedDataSet(i));
    const std::string name = stipple::memberName(members, i);
    const std::string whole =
      block.empty() ? name : block + ": " + (name.empty() ? std::to_string(i) : name);
    if (!whole.empty())
    {
      all->GetMetaData(at)->Set(vtkCompositeDataSet::NAME(), whole.c_str());
    }
  }
}
}

struct vtkPVSurfaceAlgorithm::Internals
{
  vtkSmartPointer<vtkAlgorithm> Filter;
  std::vector<InputKind> Kinds;
  stipple::OptionValues Values;
  vtkSmartPointer<vtkPiecewiseFunction> Transfer;

  std::vector<unsigned long long> Version;          ///< of the inputs that are at hand
  std::vector<stipple::Block> Surfaces;             ///< on rank 0
  std::vector<vtkSmartPointer<vtkPolyData>> Others; ///< a further port's data, or null; on rank 0
  vtkSmartPointer<vtkPartitionedDataSet> Pieces;    ///< of a filter that takes them, on all ranks

  vtkPVSurfaceAlgorithm* Self = nullptr;
  vtkNew<vtkCallbackCommand> Observer;
  std::string Sentence; ///< the first that the filter, or its executive, said
  double ProgressFrom = 0;
  double ProgressTo = 1;
  bool Stopped = false; ///< the last run was

  explicit Internals(vtkPVSurfaceAlgorithm* self)
    : Self(self)
  {
    this->Observer->SetClientData(this);
    this->Observer->SetCallback(&Internals::hear);
  }

  ~Internals()
  {
    if (this->Filter)
    {
      this->Filter->RemoveObserver(this->Observer);
      this->Filter->GetExecutive()->RemoveObserver(this->Observer);
    }
  }

  static void hear(vtkObject* caller, unsigned long event, void* data, void* callData)
  {
    auto* self = static_cast<Internals*>(data);
    if (event == vtkCommand::ErrorEvent)
    {
      if (self->Sentence.empty() && callData)
      {
        self->Sentence = stipple::sentenceOf(static_cast<const char*>(callData));
      }
    }
    else if (caller == self->Filter)
    {
      self->Self->UpdateProgress(
        self->ProgressFrom + (self->ProgressTo - self->ProgressFrom) * self->Filter->GetProgress());
      if (self->Self->GetAbortExecute())
      {
        self->Filter->SetAbortExecute(1);
      }
    }
  }

  bool isOf(int port, const char* type) const
  {
    vtkInformation* info = this->Filter->GetOutputPortInformation(port);
    return std::string(info->Get(vtkDataObject::DATA_TYPE_NAME())) == type;
  }

  bool takesPieces() const { return this->Kinds[0] == InputKind::Pieces; }

  /// Reads what comes by port 0 and the further ports, on all ranks.
  std::string read(vtkInformationVector** input, bool merge)
  {
    std::vector<stipple::BlockPiece> pieces;
    std::vector<unsigned long long> version{ merge };
    std::string sentence;
    for (std::size_t port = 0; port < this->Kinds.size(); ++port)
    {
      vtkDataObject* data = vtkDataObject::GetData(input[port]);
      version.push_back(data != nullptr);
      if (this->Kinds[port] == InputKind::Image || !data)
      {
        continue;
      }
      const stipple::Status status = stipple::collectPieces(data, static_cast<int>(port),
        this->Kinds[port] == InputKind::Points ? stipple::Taken::Points : stipple::Taken::Polygons,
        pieces, version);
      if (!status.ok() && sentence.empty())
      {
        sentence = status.message();
      }
    }
    const stipple::RankExchange ranks;
    bool changed = version != this->Version;
    ranks.agree(changed, sentence);
    this->Version.clear();
    if (!sentence.empty())
    {
      return sentence;
    }
    if (this->takesPieces())
    {
      this->keep(pieces, ranks);
    }
    else if (changed)
    {
      ranks.gather(pieces);
      this->join(pieces, merge);
    }
    this->Version = version;
    return "";
  }

  /// This rank's pieces as they are, but that their blocks are counted, over all ranks.
  void keep(std::vector<stipple::BlockPiece>& pieces, const stipple::RankExchange& ranks)
  {
    std::vector<stipple::BlockPiece> places = pieces;
    for (stipple::BlockPiece& place : places)
    {
      place.data = nullptr;
    }
    ranks.gather(places);
    std::vector<stipple::Block> blocks = stipple::joinBlocks(places, 0);
    ranks.share(blocks);
    stipple::numberPieces(blocks, pieces);
    this->Pieces = vtkSmartPointer<vtkPartitionedDataSet>::New();
    for (const stipple::BlockPiece& piece : pieces)
    {
      if (piece.data)
      {
        this->Pieces->SetPartition(this->Pieces->GetNumberOfPartitions(), piece.data);
      }
    }
  }

  void join(const std::vector<stipple::BlockPiece>& pieces, bool merge)
  {
    this->Surfaces = stipple::joinBlocks(pieces, 0);
    if (merge)
    {
      this->Surfaces = { { stipple::BlockPath(), stipple::mergeBlocks(this->Surfaces) } };
    }
    this->Others.assign(this->Kinds.size(), nullptr);
    for (std::size_t port = 1; port < this->Kinds.size(); ++port)
    {
      const std::vector<stipple::Block> blocks =
        stipple::joinBlocks(pieces, static_cast<int>(port));
      this->Others[port] = blocks.empty() ? nullptr : stipple::mergeBlocks(blocks);
    }
  }

  /// Hands the options over, and the further inputs.
  std::string prepare(vtkInformationVector** input)
  {
    std::vector<vtkDataObject*> data(this->Others.begin(), this->Others.end());
    for (std::size_t port = 1; port < this->Kinds.size(); ++port)
    {
      if (this->Kinds[port] == InputKind::Image)
      {
        data[port] = vtkImageData::GetData(input[port]);
      }
    }
    stipple::OptionValues values = this->Values;
    const std::vector<double> nodes = stipple::nodesOf(this->Transfer);
    if (!nodes.empty() && nodes != std::vector<double>{ 0, 0, 1, 1 })
    {
      values.setList("transfer", nodes);
    }
    if (const stipple::Status status = this->Self->TakeInputs(data, values); !status.ok())
    {
      return status.message();
    }
    for (const auto& [name, value] : values.given())
    {
      const stipple::Option* option = stipple::findOption(name);
      const auto* rows = std::get_if<std::vector<double>>(&value);
      const std::string wrong = option && rows ? option->wrongRows(*rows) : "";
      if (!wrong.empty())
      {
        return "The option " + name + " needs " + wrong + ".";
      }
    }
    stipple::applyOptions(values, this->Filter);
    return "";
  }

  void addRow(const char* name, std::initializer_list<double> numbers)
  {
    const stipple::Option* option = stipple::findOption(name);
    if (!option || option->columns.size() != numbers.size())
    {
      vtkErrorWithObjectMacro(
        this->Self, << "There is no option " << name << " of " << numbers.size() << " columns.");
      return;
    }
    std::vector<double> rows = this->Values.list(name);
    rows.insert(rows.end(), numbers);
    this->Values.setList(name, rows);
    this->Self->Modified();
  }

  /// Runs the filter on a surface, asked for what the first output is. The results are the
  /// caller's.
  std::string run(vtkDataObject* surface, vtkInformation* asked,
    std::vector<vtkSmartPointer<vtkDataObject>>& results)
  {
    this->Sentence.clear();
    this->Filter->SetInputDataObject(0, surface);
    const vtkNew<vtkInformation> request;
    if (this->takesPieces())
    {
      for (vtkInformationIntegerKey* key : { Pipeline::UPDATE_PIECE_NUMBER(),
             Pipeline::UPDATE_NUMBER_OF_PIECES(), Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS() })
      {
        request->CopyEntry(asked, key);
      }
    }
    const bool updated = this->Filter->Update(request) != 0;
    if (stipple::takeStop(this->Filter) || this->Self->GetAbortExecute())
    {
      this->Stopped = true;
      this->Self->SetAbortExecute(0); // newer versions of VTK leave that to us
      return "The run was stopped: the output is empty.";
    }
    if (!updated || !this->Sentence.empty())
    {
      this->Filter->Modified(); // what it left is not its result
      return !this->Sentence.empty() ? this->Sentence : "The filter failed without saying why.";
    }
    results.clear();
    for (int port = 0; port < this->Filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* result = this->Filter->GetOutputDataObject(port);
      results.push_back(vtk::TakeSmartPointer(result->NewInstance()));
      results.back()->ShallowCopy(result);
    }
    return "";
  }
};

vtkPVSurfaceAlgorithm::vtkPVSurfaceAlgorithm()
  : Data(new Internals(this))
{
}

vtkPVSurfaceAlgorithm::~vtkPVSurfaceAlgorithm() = default;

void vtkPVSurfaceAlgorithm::SetFilter(vtkAlgorithm* filter, std::initializer_list<InputKind> ports)
{
  Internals& d = *this->Data;
  d.Filter = filter;
  d.Kinds = ports;
  d.Others.assign(d.Kinds.size(), nullptr);
  filter->AddObserver(vtkCommand::ProgressEvent, d.Observer);
  filter->AddObserver(vtkCommand::ErrorEvent, d.Observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, d.Observer);
  this->SetNumberOfInputPorts(static_cast<int>(ports.size()));
  this->SetNumberOfOutputPorts(filter->GetNumberOfOutputPorts());
}

vtkAlgorithm* vtkPVSurfaceAlgorithm::GetFilter() const
{
  return this->Data->Filter;
}

stipple::Status vtkPVSurfaceAlgorithm::TakeInputs(
  const std::vector<vtkDataObject*>&, stipple::OptionValues&)
{
  return stipple::Status::success();
}

int vtkPVSurfaceAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  // Any data: blocks come as they are, not one by one, and what cannot be used gets our sentence.
  const bool isImage = this->Data->Kinds[port] == InputKind::Image;
  info->Set(INPUT_REQUIRED_DATA_TYPE(), isImage ? "vtkImageData" : "vtkDataObject");
  if (port > 0)
  {
    info->Set(INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkPVSurfaceAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  // Of blocks a port may have blocks.
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    this->Data->isOf(port, "vtkPolyData")
      ? "vtkDataObject"
      : this->Data->Filter->GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME()));
  return 1;
}

vtkTypeBool vtkPVSurfaceAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(input, output);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
    {
      output->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    }
    return 1;
  }
  if (request->Has(Pipeline::REQUEST_UPDATE_EXTENT()))
  {
    this->RequestUpdateExtent(input);
    return 1;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    this->RequestData(input, output);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

int vtkPVSurfaceAlgorithm::RequestDataObject(
  vtkInformationVector** input, vtkInformationVector* output)
{
  const char* tree = this->MergeBlocks ? nullptr : treeClassOf(vtkDataObject::GetData(input[0]));
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const char* type =
      this->Data->Filter->GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME());
    if (tree && this->Data->isOf(port, "vtkPolyData"))
    {
      type = tree;
    }
    vtkInformation* info = output->GetInformationObject(port);
    vtkDataObject* now = vtkDataObject::GetData(info);
    if (!now || std::string(now->GetClassName()) != type)
    {
      auto made = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(type));
      info->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  }
  return 1;
}

void vtkPVSurfaceAlgorithm::RequestUpdateExtent(vtkInformationVector** input)
{
  for (std::size_t port = 0; port < this->Data->Kinds.size(); ++port)
  {
    for (int i = 0; i < input[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = input[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (this->Data->Kinds[port] == InputKind::Image) // pictures are small: all of it to each rank
      {
        info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
        info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
        if (info->Has(Pipeline::WHOLE_EXTENT()))
        {
          info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
        }
      }
    }
  }
}

void vtkPVSurfaceAlgorithm::RequestData(vtkInformationVector** input, vtkInformationVector* output)
{
  Internals& d = *this->Data;
  d.Stopped = false;
  const stipple::RankExchange ranks;
  vtkInformation* asked = output->GetInformationObject(0);
  const int ports = this->GetNumberOfOutputPorts();
  for (int port = 0; port < ports; ++port)
  {
    vtkDataObject::GetData(output, port)->Initialize();
  }
  const char* tree = this->MergeBlocks ? nullptr : treeClassOf(vtkDataObject::GetData(input[0]));
  std::string sentence = d.read(input, tree == nullptr);
  const bool readable = sentence.empty();
  std::vector<std::vector<stipple::Block>> blocks(ports); // of ports with surfaces
  std::vector<vtkSmartPointer<vtkDataObject>> whole(ports);
  if (readable && d.takesPieces())
  {
    sentence = d.prepare(input);
    sentence = sentence.empty() ? d.run(d.Pieces, asked, whole) : sentence;
  }
  else if (readable && ranks.isRoot())
  {
    sentence = d.prepare(input);
    for (std::size_t i = 0; i < d.Surfaces.size() && sentence.empty(); ++i)
    {
      const stipple::Block& surface = d.Surfaces[i];
      d.ProgressFrom = static_cast<double>(i) / static_cast<double>(d.Surfaces.size());
      d.ProgressTo = static_cast<double>(i + 1) / static_cast<double>(d.Surfaces.size());
      std::vector<vtkSmartPointer<vtkDataObject>> results;
      if (!surface.data)
      {
        for (int port = 0; port < ports; ++port)
        {
          blocks[port].push_back(surface);
        }
        continue;
      }
      sentence = d.run(surface.data, asked, results);
      if (!sentence.empty())
      {
        sentence = tree ? "In " + stipple::nameOf(surface.path) + ": " + sentence : sentence;
        break;
      }
      for (int port = 0; port < ports; ++port)
      {
        auto* mesh = vtkPolyData::SafeDownCast(results[port]);
        auto* members = vtkPartitionedDataSetCollection::SafeDownCast(results[port]);
        if (tree && mesh)
        {
          blocks[port].push_back({ surface.path, mesh });
        }
        else if (tree && members)
        {
          whole[port] = whole[port]
            ? whole[port]
            : vtk::TakeSmartPointer<vtkDataObject>(vtkPartitionedDataSetCollection::New());
          append(members, stipple::nameOf(surface.path),
            vtkPartitionedDataSetCollection::SafeDownCast(whole[port]));
        }
        else
        {
          whole[port] = results[port];
        }
      }
    }
  }
  if (readable) // otherwise all ranks know it already
  {
    ranks.agree(d.Stopped, sentence);
  }
  if (!sentence.empty())
  {
    if (ranks.isRoot() && d.Stopped)
    {
      vtkWarningMacro(<< sentence);
    }
    else if (ranks.isRoot())
    {
      vtkErrorMacro(<< sentence);
    }
    d.Version.clear();
    return;
  }
  for (int port = 0; port < ports; ++port)
  {
    vtkDataObject* result = vtkDataObject::GetData(output, port);
    if (tree && d.isOf(port, "vtkPolyData"))
    {
      ranks.share(blocks[port]);
      stipple::fillTree(blocks[port], result);
    }
    else
    {
      if (whole[port])
      {
        result->ShallowCopy(whole[port]);
      }
      ranks.share(vtkPartitionedDataSetCollection::SafeDownCast(result));
    }
  }
}

void vtkPVSurfaceAlgorithm::SetNumberOption(const char* name, double value)
{
  const stipple::Option* option = stipple::findOption(name);
  if (!option || !option->apply)
  {
    vtkErrorMacro(<< "There is no option " << name << ".");
    return;
  }
  if (this->Data->Values.at(name) != stipple::OptionValue(value))
  {
    this->Data->Values.set(name, value);
    this->Modified();
  }
}

void vtkPVSurfaceAlgorithm::SetChoiceOption(const char* name, int index)
{
  const stipple::Option* option = stipple::findOption(name);
  if (!option || index < 0 || index >= static_cast<int>(option->choices.size()))
  {
    vtkErrorMacro(<< "There is no option " << name << " with a choice " << index << ".");
    return;
  }
  this->SetTextOption(name, option->choices[static_cast<std::size_t>(index)].c_str());
}

void vtkPVSurfaceAlgorithm::SetTextOption(const char* name, const char* text)
{
  const stipple::Option* option = stipple::findOption(name);
  if (!option || !option->apply)
  {
    vtkErrorMacro(<< "There is no option " << name << ".");
    return;
  }
  const std::string none = "None"; // as ParaView's list of arrays says it
  const std::string value =
    !text || (option->kind == stipple::Option::Kind::Text && text == none) ? "" : text;
  if (this->Data->Values.at(name) != stipple::OptionValue(value))
  {
    this->Data->Values.set(name, value);
    this->Modified();
  }
}

void vtkPVSurfaceAlgorithm::ClearRows(const char* name)
{
  const stipple::Option* option = stipple::findOption(name);
  if (!option || option->columns.empty())
  {
    vtkErrorMacro(<< "There is no option " << name << " of rows.");
    return;
  }
  this->Data->Values.setList(name, {});
  this->Modified();
}

// Client-server wrapping passes a fixed number of arguments.
void vtkPVSurfaceAlgorithm::AddRow(const char* name, double a, double b)
{
  this->Data->addRow(name, { a, b });
}

void vtkPVSurfaceAlgorithm::AddRow(const char* name, double a, double b, double c)
{
  this->Data->addRow(name, { a, b, c });
}

void vtkPVSurfaceAlgorithm::AddRow(
  const char* name, double a, double b, double c, double d, double e)
{
  this->Data->addRow(name, { a, b, c, d, e });
}

void vtkPVSurfaceAlgorithm::SetTransferFunction(vtkPiecewiseFunction* function)
{
  if (this->Data->Transfer != function)
  {
    this->Data->Transfer = function;
    this->Modified();
  }
}

vtkMTimeType vtkPVSurfaceAlgorithm::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Data->Transfer ? std::max(time, this->Data->Transfer->GetMTime()) : time;
}

void vtkPVSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeBlocks: " << this->MergeBlocks << "\n";
  os << indent << "Options:\n";
  for (const auto& [name, value] : this->Data->Values.given())
  {
    os << indent.GetNextIndent() << name << ":";
    if (const auto* number = std::get_if<double>(&value))
    {
      os << " " << stipple::shortestText(*number);
    }
    else if (const auto* text = std::get_if<std::string>(&value))
    {
      os << " " << *text;
    }
    for (const double number : this->Data->Values.list(name))
    {
      os << " " << stipple::shortestText(number);
    }
    os << "\n";
  }
  os << indent << "Filter:\n";
  this->Data->Filter->PrintSelf(os, indent.GetNextIndent());
}
