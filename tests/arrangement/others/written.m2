S = QQ[x_1..x_3, Degrees => {3:1}, Heft => {1}]
A = arrangement {x_1, x_2-1/2, 2*x_1-(3/2)*x_2+(1/3)*x_3, -x_1+x_3}
-- poincare: 1+4*T+6*T^2+4*T^3
