#pragma once

#include <IpTNLP.hpp>
#include <vector>

#include "../nlp.h"
#include "fourwis_navigation/model/interrupt.h"

namespace fourwis
{

/// A nonlinear program in the interface of Ipopt. Keeps references to program and interrupt.
class IpoptProgram : public Ipopt::TNLP
{
public:
  IpoptProgram(const Nlp& nlp, const Interrupt& interrupt);

  const std::vector<double>& x() const { return x_; }
  int iterations() const { return iterations_; }

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian_entries, Ipopt::Index& hessian_entries,
                    IndexStyleEnum& index_style) override;
  bool get_bounds_info(Ipopt::Index n, Ipopt::Number* x_l, Ipopt::Number* x_u, Ipopt::Index m, Ipopt::Number* g_l,
                       Ipopt::Number* g_u) override;
  bool get_starting_point(Ipopt::Index n, bool init_x, Ipopt::Number* x, bool init_z, Ipopt::Number* z_l,
                          Ipopt::Number* z_u, Ipopt::Index m, bool init_lambda, Ipopt::Number* lambda) override;
  bool eval_f(Ipopt::Index n, const Ipopt::Number* x, bool new_x, Ipopt::Number& f) override;
  bool eval_grad_f(Ipopt::Index n, const Ipopt::Number* x, bool new_x, Ipopt::Number* gradient) override;
  bool eval_g(Ipopt::Index n, const Ipopt::Number* x, bool new_x, Ipopt::Index m, Ipopt::Number* g) override;
  bool eval_jac_g(Ipopt::Index n, const Ipopt::Number* x, bool new_x, Ipopt::Index m, Ipopt::Index entries,
                  Ipopt::Index* rows, Ipopt::Index* columns, Ipopt::Number* values) override;
  bool eval_h(Ipopt::Index n, const Ipopt::Number* x, bool new_x, Ipopt::Number s, Ipopt::Index m,
              const Ipopt::Number* y, bool new_y, Ipopt::Index entries, Ipopt::Index* rows, Ipopt::Index* columns,
              Ipopt::Number* values) override;
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Ipopt::Index iteration, Ipopt::Number f, Ipopt::Number primal,
                             Ipopt::Number dual, Ipopt::Number mu, Ipopt::Number d_norm, Ipopt::Number regularization,
                             Ipopt::Number alpha_dual, Ipopt::Number alpha_primal, Ipopt::Index trials,
                             const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities) override;
  void finalize_solution(Ipopt::SolverReturn status, Ipopt::Index n, const Ipopt::Number* x, const Ipopt::Number* z_l,
                         const Ipopt::Number* z_u, Ipopt::Index m, const Ipopt::Number* g, const Ipopt::Number* lambda,
                         Ipopt::Number f, const Ipopt::IpoptData* data,
                         Ipopt::IpoptCalculatedQuantities* quantities) override;

private:
  const NlpElement& gather(std::size_t i, const double* x);
  const NlpElement::Derivatives& differentiate(std::size_t i, const double* x, double s, const double* y);

  const Nlp& nlp_;
  const Interrupt& interrupt_;
  int rows_ = 0, jacobian_entries_ = 0, hessian_entries_ = 0;
  std::vector<int> first_row_;  ///< of each element
  std::vector<double> x_;
  int iterations_ = 0;

  // Of the element at hand.
  Eigen::VectorXd local_x_, local_y_, local_rows_;
  NlpElement::Derivatives derivatives_;
};

}  // namespace fourwis
