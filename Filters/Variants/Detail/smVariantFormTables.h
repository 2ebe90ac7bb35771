/**
 * @file smVariantFormTables.h
 * @brief The forms of all moments, or of their derivatives, as matrices of the kernels
 */
#ifndef smVariantFormTables_h
#define smVariantFormTables_h

#include "smVariantKernels.h"
#include "smVariantMonomials.h"

#include <cstddef>
#include <vector>

namespace sm
{
/// Matrices of the volume, the first and the second moments, with what they refer to.
struct FormTables
{
  std::vector<std::size_t> Counts;
  std::vector<std::vector<double>> Entries;
  std::vector<VariantMatrix> Matrices;
  VariantForms Forms;

  void Begin(const VariantMonomials& monomials, int degree)
  {
    for (int d = 0; d <= MaximumFormDegree; ++d)
    {
      for (int n = 0; n <= monomials.GetVariables(); ++n)
      {
        this->Counts.push_back(monomials.GetCount(d, n));
      }
    }
    this->Forms.Variables = monomials.GetVariables();
    this->Forms.MaximumDegree = degree;
  }
  /// Adds a matrix; `get(row, column)` gives its entries.
  template <typename Get>
  void Add(int degree, std::size_t rows, std::size_t columns, const Get& get)
  {
    VariantMatrix matrix;
    matrix.Degree = degree;
    matrix.Rows = rows;
    matrix.Columns = (columns + 3) / 4 * 4;
    std::vector<double> entries(matrix.Rows * matrix.Columns, 0.0);
    for (std::size_t column = 0; column < columns; ++column)
    {
      for (std::size_t row = 0; row < rows; ++row)
      {
        entries[(column / 4 * rows + row) * 4 + column % 4] = get(row, column);
      }
    }
    this->Entries.push_back(std::move(entries));
    this->Matrices.push_back(matrix);
    this->Forms.TotalColumns += matrix.Columns;
  }
  void Finish()
  {
    for (std::size_t i = 0; i < this->Matrices.size(); ++i)
    {
      this->Matrices[i].Entries = this->Entries[i].data();
    }
    this->Forms.Counts = this->Counts.data();
    this->Forms.Matrices = this->Matrices.data();
    this->Forms.MatrixCount = this->Matrices.size();
  }
};
}

#endif
