# Fits lives with survreg of package survival, an implementation that shares nothing with host_sim.
#
#   Rscript survreg.R LIVES.csv FORMULAS DISTRIBUTION...
#
# LIVES.csv has the columns life, failed (0 or 1) and x. FORMULAS are right-hand sides, e.g. 1, x or
# factor(x), with ; between them. Prints one line for each formula and distribution: log likelihood,
# scale, coefficients.
suppressPackageStartupMessages(library(survival))

arguments <- commandArgs(trailingOnly = TRUE)
lives <- read.csv(arguments[1])
accurate <- survreg.control(maxiter = 200, rel.tolerance = 1e-13)
for (formula in strsplit(arguments[2], ";")[[1]]) {
  model <- as.formula(paste("Surv(life, failed) ~", formula))
  for (distribution in arguments[-(1:2)]) {
    fit <- survreg(model, lives, dist = distribution, control = accurate)
    numbers <- c(fit$loglik[length(fit$loglik)], fit$scale, coef(fit))
    cat(sprintf("%.12g", numbers), "\n")
  }
}
