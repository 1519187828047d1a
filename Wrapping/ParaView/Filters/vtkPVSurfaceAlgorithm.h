// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVSurfaceAlgorithm
 * @brief   superclass of what runs a filter of Stipple's on a surface inside ParaView
 *
 * vtkPVSurfaceAlgorithm has a filter that takes one vtkPolyData, and does around it what ParaView
 * needs:
 *
 * - Input port 0 takes a surface, or blocks of surfaces: a vtkMultiBlockDataSet,
 * vtkPartitionedDataSet or vtkPartitionedDataSetCollection. What is no surface is an error that
 * names the block. Partitions and pieces of one data set are parts of one surface, whose cracks are
 * closed. Ghost cells are left out. Blocks are merged to one surface, with the cell array "BlockId"
 * (int) that counts them, or each is worked on alone (MergeBlocks).
 * - What the filter takes by setters as data comes by further input ports (see the subclasses).
 * - Options are set by their names in stipple::optionTable(), so that ParaView's properties can be
 * made of that table.
 * - With several ranks, all pieces of all inputs go to rank 0, which runs the filter. The other
 * ranks have empty outputs of the same structure. But a filter that takes pieces is run by all
 * ranks, each with its own ones in a vtkPartitionedDataSet, and asked for ghost cells as output
 * port 0 is.
 * - A failure on any rank ends all: outputs are empty, and rank 0 says one sentence. RequestData()
 * answers 1 then, so that ParaView neither repeats the run with every frame nor says more. So it is
 * with a run that was stopped by SetAbortExecute(1), but for the sentence, which is a warning.
 *
 * Output ports are the filter's. If blocks are worked on alone, those of vtkPolyData are of the
 * input's class, vtkMultiBlockDataSet or vtkPartitionedDataSetCollection, with the input's blocks;
 * those that are collections have the blocks' collections one behind the other.
 *
 * @warning The gathered surface must fit into the memory of rank 0. Its points and cells are those
 * of the ranks in their order, and ids in options and provenance arrays count them.
 *
 * @sa vtkPVGeometryRemesher vtkPVGeometryRemesherInBlocks vtkPVConformalAtlas vtkPVSurfaceQuality
 */
#ifndef vtkPVSurfaceAlgorithm_h
#define vtkPVSurfaceAlgorithm_h

#include "StippleParaViewFiltersModule.h" // for export macro
#include "vtkAlgorithm.h"

#include <initializer_list> // for SetFilter
#include <memory>           // for std::unique_ptr
#include <vector>           // for TakeInputs

class vtkDataObject;
class vtkPiecewiseFunction;

namespace stipple
{
class OptionValues;
class Status;
}

class STIPPLEPARAVIEWFILTERS_EXPORT vtkPVSurfaceAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkPVSurfaceAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether blocks become one surface. Only vtkPVGeometryRemesher can do without. The default is
  /// true.
  vtkSetMacro(MergeBlocks, bool);
  vtkGetMacro(MergeBlocks, bool);
  ///@}

  ///@{
  /// An option by its name in the table: a number, a choice's index, or a text, of which "" and
  /// "None" are none. The defaults are the table's. It is an error if there is none of that name.
  void SetNumberOption(const char* name, double value);
  void SetChoiceOption(const char* name, int index);
  void SetTextOption(const char* name, const char* text);
  ///@}

  ///@{
  /// Rows of an option, with as many numbers as it has columns. The default is no row, or the
  /// table's.
  void ClearRows(const char* name);
  void AddRow(const char* name, double a, double b);
  void AddRow(const char* name, double a, double b, double c);
  void AddRow(const char* name, double a, double b, double c, double d, double e);
  ///@}

  /// The option "transfer" as a function on [0, 1]. The identity and nullptr are none; the default
  /// is nullptr.
  void SetTransferFunction(vtkPiecewiseFunction* function);

  vtkMTimeType GetMTime() override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

protected:
  vtkPVSurfaceAlgorithm();
  ~vtkPVSurfaceAlgorithm() override;

  enum class InputKind
  {
    Surface,
    Pieces, ///< a surface that each rank has its pieces of; it is the only port then
    Curves, ///< vtkPolyData, plain or in blocks, which are merged
    Points, ///< vtkPointSet, plain or in blocks, which are merged
    Image   ///< vtkImageData
  };
  /// Called once, by the constructor of a subclass. All ports but the first are optional.
  void SetFilter(vtkAlgorithm* filter, std::initializer_list<InputKind> ports);

  vtkAlgorithm* GetFilter() const;

  /// Hands over what came by the further ports, before the filter runs on rank 0, or on all ranks
  /// if it takes pieces: options that `values` may add to, and data. A port's data are null if it
  /// has none.
  virtual stipple::Status TakeInputs(
    const std::vector<vtkDataObject*>& data, stipple::OptionValues& values);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  vtkPVSurfaceAlgorithm(const vtkPVSurfaceAlgorithm&) = delete;
  void operator=(const vtkPVSurfaceAlgorithm&) = delete;

  int RequestDataObject(vtkInformationVector** input, vtkInformationVector* output);
  void RequestUpdateExtent(vtkInformationVector** input);
  void RequestData(vtkInformationVector** input, vtkInformationVector* output);

  bool MergeBlocks = true;
  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
