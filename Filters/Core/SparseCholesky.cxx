// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SparseCholesky.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>

#include <algorithm>

namespace stipple
{
namespace
{
using Matrix = SparseCholesky::Matrix;

/// Columns that are eliminated between two looks at whether to stop.
constexpr int BlockSize = 128;

/// Whether a front of so many columns takes one more, if so many of its entries are zero then:
/// Ashcraft and Grimes (1989), with the limits of CHOLMOD (Chen et al. 2008).
bool mayGrow(int columns, double zeros, double entries)
{
  return zeros == 0 || columns < 4 ||
    zeros < (columns < 16      ? 0.8
                : columns < 48 ? 0.1
                               : 0.05) *
      entries;
}

/// The parents of columns in the elimination tree, -1 for roots (Liu 1990).
std::vector<int> eliminationTree(const Matrix& lower)
{
  const Matrix upper = lower.transpose();
  std::vector<int> parent(static_cast<std::size_t>(upper.cols()), -1);
  std::vector<int> ancestor = parent;
  for (int k = 0; k < static_cast<int>(upper.cols()); ++k)
  {
    for (Matrix::InnerIterator it(upper, k); it; ++it)
    {
      for (int i = static_cast<int>(it.row()); i != -1 && i < k;)
      {
        const int next = ancestor[i];
        ancestor[i] = k;
        if (next == -1)
        {
          parent[i] = k;
        }
        i = next;
      }
    }
  }
  return parent;
}

/// Children before parents, subtree by subtree.
std::vector<int> postorder(const std::vector<int>& parent)
{
  const int n = static_cast<int>(parent.size());
  std::vector<int> firstChild(parent.size() + 1, -1); // of roots: the last one's
  std::vector<int> sibling(parent.size(), -1);
  for (int v = n - 1; v >= 0; --v)
  {
    int& first = firstChild[parent[v] < 0 ? n : parent[v]];
    sibling[v] = first;
    first = v;
  }
  std::vector<int> result;
  result.reserve(parent.size());
  std::vector<int> path;
  for (int root = firstChild[n]; root >= 0; root = sibling[root])
  {
    path.push_back(root);
    while (!path.empty())
    {
      const int v = path.back();
      const int child = firstChild[v];
      if (child >= 0)
      {
        firstChild[v] = sibling[child];
        path.push_back(child);
      }
      else
      {
        result.push_back(v);
        path.pop_back();
      }
    }
  }
  return result;
}
}

Matrix SparseCholesky::permuted(const Matrix& lower) const
{
  Matrix result(lower.rows(), lower.cols());
  result.selfadjointView<Eigen::Lower>() =
    lower.selfadjointView<Eigen::Lower>().twistedBy(this->Order);
  return result;
}

bool SparseCholesky::order(const Matrix& lower, const Stop& stop)
{
  Permutation columns;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), columns);
  this->Order = columns.inverse();
  if (isAsked(stop))
  {
    return false;
  }
  const Matrix inOrder = this->permuted(lower);
  if (isAsked(stop))
  {
    return false;
  }
  const std::vector<int> post = postorder(eliminationTree(inOrder));
  std::vector<int> place(post.size());
  for (std::size_t i = 0; i < post.size(); ++i)
  {
    place[post[i]] = static_cast<int>(i);
  }
  for (Eigen::Index i = 0; i < this->Order.size(); ++i)
  {
    this->Order.indices()[i] = place[this->Order.indices()[i]];
  }
  return !isAsked(stop);
}

bool SparseCholesky::findFronts(const Matrix& lower, const Stop& stop)
{
  const int n = static_cast<int>(lower.cols());
  const std::vector<int> parent = eliminationTree(lower);
  if (isAsked(stop))
  {
    return false;
  }
  std::vector<std::vector<int>> children(parent.size());
  std::vector<std::vector<int>> below(parent.size()); // rows under the front that ends there
  std::vector<int> begin(parent.size());              // of that front
  std::vector<int> seenBy(parent.size(), -1);
  std::vector<char> goesOn(parent.size(), 0);
  for (int j = 0; j < n; ++j)
  {
    if (isTimeToAsk(static_cast<std::size_t>(j)) && isAsked(stop))
    {
      return false;
    }
    std::vector<int>& rows = below[j];
    const auto add = [&](int r) {
      if (r > j && seenBy[r] != j)
      {
        seenBy[r] = j;
        rows.push_back(r);
      }
    };
    for (Matrix::InnerIterator it(lower, j); it; ++it)
    {
      add(static_cast<int>(it.row()));
    }
    for (const int child : children[j])
    {
      std::for_each(below[child].begin(), below[child].end(), add);
    }
    std::sort(rows.begin(), rows.end());
    begin[j] = j;
    if (j > 0 && parent[j - 1] == j)
    {
      const int columns = j - begin[j - 1];
      const double size = static_cast<double>(rows.size()) + 1.;
      const double zeros = columns * (size - static_cast<double>(below[j - 1].size()));
      if (mayGrow(columns, zeros, (columns + 1) * size))
      {
        begin[j] = begin[j - 1];
        goesOn[j - 1] = 1;
        std::vector<int>().swap(below[j - 1]);
      }
    }
    if (parent[j] >= 0)
    {
      children[parent[j]].push_back(j);
    }
  }
  this->Fronts.clear();
  this->Rows.clear();
  std::vector<int> frontOf(parent.size(), -1);
  std::size_t size = 0;
  for (int j = 0; j < n; ++j)
  {
    if (goesOn[j] == 0)
    {
      Front front;
      front.begin = begin[j];
      front.end = j + 1;
      front.rows = this->Rows.size();
      for (int column = front.begin; column < front.end; ++column)
      {
        this->Rows.push_back(column);
        frontOf[column] = static_cast<int>(this->Fronts.size());
      }
      this->Rows.insert(this->Rows.end(), below[j].begin(), below[j].end());
      front.rowsEnd = this->Rows.size();
      front.panel = size;
      size += static_cast<std::size_t>(front.numberOfRows()) *
        static_cast<std::size_t>(front.numberOfColumns());
      this->Fronts.push_back(front);
    }
  }
  for (const Front& front : this->Fronts)
  {
    if (front.numberBelow() > 0)
    {
      ++this->Fronts[frontOf[this->row(front, front.numberOfColumns())]].numberOfChildren;
    }
  }
  this->Panels.resize(static_cast<Eigen::Index>(size));
  return true;
}

bool SparseCholesky::eliminate(const Matrix& lower, const Stop& stop)
{
  struct Update
  {
    const Front* from;
    Eigen::MatrixXd values; // over the rows below it; the lower triangle
  };
  std::vector<Update> updates; // those of the children of the next front come last
  std::vector<int> place(static_cast<std::size_t>(lower.cols())); // of a row in the front
  for (const Front& front : this->Fronts)
  {
    const int columns = front.numberOfColumns();
    const int rows = front.numberOfRows();
    Eigen::Map<Eigen::MatrixXd> panel(this->Panels.data() + front.panel, rows, columns);
    panel.setZero();
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(rows - columns, rows - columns);
    for (int i = 0; i < rows; ++i)
    {
      place[this->row(front, i)] = i;
    }
    for (int c = 0; c < columns; ++c)
    {
      for (Matrix::InnerIterator it(lower, front.begin + c); it; ++it)
      {
        panel(place[it.row()], c) = it.value();
      }
    }
    const auto firstUpdate = updates.end() - front.numberOfChildren;
    for (auto update = firstUpdate; update != updates.end(); ++update)
    {
      const int first = update->from->numberOfColumns();
      for (int c = 0; c < update->values.cols(); ++c)
      {
        const int to = place[this->row(*update->from, first + c)];
        for (int r = c; r < update->values.rows(); ++r)
        {
          const int at = place[this->row(*update->from, first + r)];
          (to < columns ? panel(at, to) : rest(at - columns, to - columns)) += update->values(r, c);
        }
      }
    }
    updates.erase(firstUpdate, updates.end());
    for (int c = 0; c < columns; c += BlockSize)
    {
      if (isAsked(stop))
      {
        return false;
      }
      const int size = std::min(BlockSize, columns - c);
      const int left = columns - c - size;
      Eigen::Ref<Eigen::MatrixXd> block = panel.block(c, c, size, size);
      if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(block).info() != Eigen::Success)
      {
        return false;
      }
      auto under = panel.block(c + size, c, rows - c - size, size);
      block.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(under);
      if (left > 0)
      {
        panel.bottomRightCorner(rows - c - size, left).noalias() -=
          under * under.topRows(left).transpose();
      }
      if (rows > columns)
      {
        rest.selfadjointView<Eigen::Lower>().rankUpdate(under.bottomRows(rows - columns), -1.);
      }
    }
    if (rows > columns)
    {
      updates.push_back({ &front, std::move(rest) });
    }
  }
  return true;
}

bool SparseCholesky::factorize(const Matrix& lower, const Stop& stop)
{
  if (lower.cols() == 0)
  {
    this->Fronts.clear();
    this->Order.resize(0);
    return true;
  }
  if (isAsked(stop))
  {
    return false;
  }
  if (!this->order(lower, stop))
  {
    return false;
  }
  const Matrix inOrder = this->permuted(lower);
  return !isAsked(stop) && this->findFronts(inOrder, stop) && this->eliminate(inOrder, stop);
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& rightHandSides) const
{
  Eigen::MatrixXd x = this->Order * rightHandSides;
  Eigen::MatrixXd part;
  const auto panelOf = [this](const Front& front) {
    return Eigen::Map<const Eigen::MatrixXd>(
      this->Panels.data() + front.panel, front.numberOfRows(), front.numberOfColumns());
  };
  for (const Front& front : this->Fronts)
  {
    const int columns = front.numberOfColumns();
    const auto panel = panelOf(front);
    auto own = x.middleRows(front.begin, columns);
    panel.topRows(columns).triangularView<Eigen::Lower>().solveInPlace(own);
    part.noalias() = panel.bottomRows(front.numberBelow()) * own;
    for (int i = 0; i < front.numberBelow(); ++i)
    {
      x.row(this->row(front, columns + i)) -= part.row(i);
    }
  }
  for (auto front = this->Fronts.rbegin(); front != this->Fronts.rend(); ++front)
  {
    const int columns = front->numberOfColumns();
    const auto panel = panelOf(*front);
    part.resize(front->numberBelow(), x.cols());
    for (int i = 0; i < front->numberBelow(); ++i)
    {
      part.row(i) = x.row(this->row(*front, columns + i));
    }
    auto own = x.middleRows(front->begin, columns);
    own.noalias() -= panel.bottomRows(front->numberBelow()).transpose() * part;
    panel.topRows(columns).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
  return this->Order.transpose() * x;
}
}
