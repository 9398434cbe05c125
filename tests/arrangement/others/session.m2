
i1 : needsPackage "HyperplaneArrangements"

o1 = HyperplaneArrangements

o1 : Package

i2 : S = QQ[u,v]

o2 = S

o2 : PolynomialRing

i3 : R = QQ[x,y,z]

o3 = R

o3 : PolynomialRing

i4 : A = arrangement {x,y,z,x-y,x-z,y-z,2*x-3/2*y+1/3*z}

                                         3    1
o4 = {x, y, z, x - y, x - z, y - z, 2x - -y + -z}
                                         2    3

o4 : Hyperplane Arrangement

i5 : poincare A

                 2      3
o5 = 1 + 7T + 17T  + 11T

o5 : ZZ[T]

i6 :
