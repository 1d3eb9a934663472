#pragma once

#include <cstddef>
#include <vector>

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/optimize/paper_optimizer.h"
#include "nlp.h"

namespace fourwis
{

/// The disc centres of knot k: their share of J_geom, and the rows that keep them in their boxes:
///   c = weight |g|^2 T/N,   O_f(x) + g_f and O_r(x) + g_r in the boxes.
class PaperDiscs : public NlpElement
{
public:
  /// `variables`: x, y, theta, T, g_f, g_r.
  PaperDiscs(double offset, const PaperOptions& options, std::size_t steps, const Box& front, const Box& rear,
             std::vector<int> variables);

  double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const override;
  void differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& y, Derivatives& d) const override;

private:
  const double offset_, weight_, steps_;
};

}  // namespace fourwis
