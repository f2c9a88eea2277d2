C     ELIMINATION BY ROWS AS IN 1987. A(K,I) IS ENTRY K OF ROW I.
      SUBROUTINE ROWS (N, A, X)
      INTEGER N, I, J, K, L
      REAL*8 A(N,N), X(N), F
      DO 50 I = 1, N
        L = I
        DO 10 J = I + 1, N
          IF (DABS(A(I,J)) .GT. DABS(A(I,L))) L = J
   10   CONTINUE
        IF (L .EQ. I) GO TO 25
        DO 20 K = 1, N
          F = A(K,I)
          A(K,I) = A(K,L)
          A(K,L) = F
   20   CONTINUE
        F = X(I)
        X(I) = X(L)
        X(L) = F
   25   DO 40 J = I + 1, N
          F = -A(I,J)/A(I,I)
          DO 30 K = I + 1, N
            A(K,J) = A(K,J) + F*A(K,I)
   30     CONTINUE
          X(J) = X(J) + F*X(I)
   40   CONTINUE
   50 CONTINUE
      DO 70 I = N, 1, -1
        DO 60 K = I + 1, N
          X(I) = X(I) - A(K,I)*X(K)
   60   CONTINUE
        X(I) = X(I)/A(I,I)
   70 CONTINUE
      END
