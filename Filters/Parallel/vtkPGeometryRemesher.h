// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPGeometryRemesher
 * @brief   remesh a surface block by block, on one rank or on many, with exactly so many points
 *
 * vtkPGeometryRemesher cuts a triangle surface into blocks by k-d cuts of its triangles' centres,
 * samples the borders of blocks once, remeshes each block with these samples by GetRemesher(), and
 * optimises the mesh along the borders until they cannot be told. Ranks of the controller share
 * the blocks. What comes of it depends on the surface and the parameters, not on the number of
 * ranks: pieces of the input, rank by rank, are the surface.
 *
 * Input: on every rank a vtkPolyData, a piece of the surface (it may be empty), or a
 * vtkPartitionedDataSet of such. Where pieces meet, points at the same place, to the last bit, are
 * one; or, if all pieces have global ids of points, those of the same id are.
 *
 * Output port 0: a vtkPartitionedDataSet with one vtkPolyData of triangles a block, on the rank
 * that the block was dealt to, null elsewhere; blocks are cut anew along triangles of the mesh.
 * Points have global ids from 0 to NumberOfPoints - 1: those of the same id are one point, which
 * several partitions may have. Point arrays: those of the input, float and double ones
 * interpolated, others those of the nearest of the triangle's points; and `SourceCellId`, the cell
 * of the input below, of which those of all pieces are counted in a row. Cell arrays: those of the
 * input at the cell below. Where ghost cells are asked for, triangles of other partitions come
 * behind a partition's own, and arrays `vtkGhostType` of points and cells tell what is there twice:
 * each triangle, and each point, is no ghost in one partition. Output port 1, on the first rank:
 * the borders of the blocks that the surface was cut into, a vtkPolyData of polylines from sample
 * to sample with the cell array `BlockIds` (two blocks each).
 *
 * Of GetRemesher() count: the importances UNIFORM and ARRAY with Gamma, FeatureAngle,
 * RegionArrayName and MinimumFeatureLength of its atlas, and the parameters of its optimiser.
 * Features are found in a block and what touches its bounding box. With more than one block sizes
 * do not grow from features, tips of cones are no vertices, and features, curves and constraints
 * that are given by the input's ids or places are errors.
 *
 * Where something fails, on any rank, it is the error of all ranks, with one sentence, and all
 * outputs are empty. All ranks must execute, also those without input.
 *
 * @warning The surface must be oriented alike, and manifold, where it is cut into blocks; within
 * blocks it is repaired.
 * @warning Each rank holds its part of the input and of the mesh.
 *
 * @sa vtkGeometryRemesher
 */
#ifndef vtkPGeometryRemesher_h
#define vtkPGeometryRemesher_h

#include "StippleFiltersParallelModule.h" // for export macro
#include "vtkPartitionedDataSetAlgorithm.h"

class vtkGeometryRemesher;
class vtkMultiProcessController;

class STIPPLEFILTERSPARALLEL_EXPORT vtkPGeometryRemesher : public vtkPartitionedDataSetAlgorithm
{
public:
  static vtkPGeometryRemesher* New();
  vtkTypeMacro(vtkPGeometryRemesher, vtkPartitionedDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The ranks that share the work. The default is VTK's global controller at the time the filter
  /// was made; null is one rank.
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /// The exact number of points of the mesh of all ranks, 0 to 2,147,483,647; 0 is half as many as
  /// the surface has triangles. The default is 0.
  vtkSetClampMacro(NumberOfPoints, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /// The most triangles of the input that a block has, 100 or more (but where centres of triangles
  /// have the same coordinate). It is what a rank works on at a time; with one block the filter
  /// does what GetRemesher() does. The default is 300,000.
  vtkSetClampMacro(TrianglesPerBlock, vtkIdType, 100, VTK_ID_MAX);
  vtkGetMacro(TrianglesPerBlock, vtkIdType);
  ///@}

  ///@{
  /// How far from borders points are moved to heal them, in edges of the mesh, 2 to 50. The
  /// default is 6.
  vtkSetClampMacro(HealingRings, int, 2, 50);
  vtkGetMacro(HealingRings, int);
  ///@}

  ///@{
  /// Rings of other partitions' triangles that each partition of the mesh gets as ghost cells, 0 to
  /// 100; what the pipeline asks for counts where it is more (of one piece it asks for none). The
  /// default is 0.
  vtkSetClampMacro(MinimumNumberOfGhostLevels, int, 0, 100);
  vtkGetMacro(MinimumNumberOfGhostLevels, int);
  ///@}

  /// What remeshes the blocks, for its parameters; its NumberOfPoints and input do not count.
  vtkGeometryRemesher* GetRemesher();

  ///@{
  /// After an update: blocks of the surface; vertices of the mesh that were put on borders; bytes
  /// that this rank sent to others.
  vtkGetMacro(NumberOfBlocks, int);
  vtkGetMacro(NumberOfBorderPoints, int);
  vtkGetMacro(BytesSent, double);
  ///@}

  /// After an update that failed with vtkGeometryRemesher::TOO_FEW_POINTS: a number that may work,
  /// or 0.
  vtkGetMacro(LeastNumberOfPoints, int);

  /// Of an update, in seconds of this rank: blocks are made and moved, borders sampled, blocks
  /// remeshed, borders healed, and arrays carried over.
  enum PhaseType
  {
    DISTRIBUTION = 0,
    BORDERS = 1,
    REMESHING = 2,
    HEALING = 3,
    OUTPUT = 4,
    NUMBER_OF_PHASES = 5
  };
  double GetPhaseSeconds(int phase);

  vtkMTimeType GetMTime() override;

protected:
  vtkPGeometryRemesher();
  ~vtkPGeometryRemesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPGeometryRemesher(const vtkPGeometryRemesher&) = delete;
  void operator=(const vtkPGeometryRemesher&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  int NumberOfPoints = 0;
  vtkIdType TrianglesPerBlock = 300000;
  int HealingRings = 6;
  int MinimumNumberOfGhostLevels = 0;
  vtkGeometryRemesher* Remesher;
  int NumberOfBlocks = 0;
  int NumberOfBorderPoints = 0;
  int LeastNumberOfPoints = 0;
  double BytesSent = 0;
  double PhaseSeconds[NUMBER_OF_PHASES] = {};
};

#endif
