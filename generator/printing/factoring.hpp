// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/printing/written.hpp"

// Taking out what the terms of a sum share, the way a person does.

namespace torsor::printing {

WrittenFactor parenthesised(Written inside);

/// Factors in the order of writing: lowest level first, functions after the symbols of their level.
std::vector<WrittenFactor> written(const Product& product);

/// Puts factors where they stand on paper: by level, a sum in parentheses at the place of its first symbol.
void put_in_order(std::vector<WrittenFactor>& factors);

/// The greatest product of whole powers that divides every term; under the stroke what every term has there.
Product common_factor(const Sum& sum);
Product inverse(Product product);

/// The greatest rational that all coefficients share, if it is short; positive.
Number shared_number(const Sum& sum);

/// The sum or the term whose square this is, with a plus in front; nothing when there is none.
std::optional<Sum> square_root(const Sum& sum);

/// One term: number · common factor · (sum of the rest). Sums of parameters come out as (M1 + M2) l^2.
WrittenTerm as_term(const Sum& sum);

/// Several terms: those that share a parameter are put together.
Written factored(const Sum& sum);

}  // namespace torsor::printing
