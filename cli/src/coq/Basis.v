(** What the proofs of `basis check --coq` have in common: polynomials and quotients of polynomials over the rational
    numbers as data, the functions of real numbers that they stand for, and programs that decide identities, signs and
    independence of such data, each with a theorem that says that its answer is right.

    A theorem of a family is stated in the ordinary terms of the real numbers; nothing of this file occurs in it. Its
    proof gives the same formula as data, of type [expr], lets Coq see that [eval] of the data is the formula, and runs
    one of the programs.

    Needs Coq 8.16 or newer and Coquelicot 3. *)

From Coq Require Import Reals QArith Qreals List Lra Lia ZArith Bool.
From Coquelicot Require Import Coquelicot.
Import List ListNotations.
Open Scope R_scope.

(** * Rational numbers *)

(** Sums and products in lowest terms; whole numbers, which are most frequent, need no common divisor. *)
Definition whole (a : Q) : bool := Pos.eqb (Qden a) 1.
Definition qadd (a b : Q) : Q :=
  if (whole a && whole b)%bool then Qmake (Qnum a + Qnum b) 1 else Qred (a + b).
Definition qmul (a b : Q) : Q :=
  if (whole a && whole b)%bool then Qmake (Qnum a * Qnum b) 1 else Qred (a * b).
Definition qzero (a : Q) : bool := Z.eqb (Qnum a) 0.
Definition qone (a : Q) : bool := (Z.eqb (Qnum a) 1 && whole a)%bool.
Definition qsame (a b : Q) : bool := (Z.eqb (Qnum a) (Qnum b) && Pos.eqb (Qden a) (Qden b))%bool.

Lemma Q2R_red a : Q2R (Qred a) = Q2R a.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma qadd_ok a b : Q2R (qadd a b) = Q2R a + Q2R b.
Proof.
  unfold qadd. destruct (whole a && whole b)%bool eqn:E; [|rewrite Q2R_red; apply Q2R_plus].
  apply andb_prop in E as [A B]. apply Pos.eqb_eq in A. apply Pos.eqb_eq in B.
  destruct a, b; unfold Q2R; simpl in *; subst. rewrite plus_IZR. field.
Qed.

Lemma qmul_ok a b : Q2R (qmul a b) = Q2R a * Q2R b.
Proof.
  unfold qmul. destruct (whole a && whole b)%bool eqn:E; [|rewrite Q2R_red; apply Q2R_mult].
  apply andb_prop in E as [A B]. apply Pos.eqb_eq in A. apply Pos.eqb_eq in B.
  destruct a, b; unfold Q2R; simpl in *; subst. rewrite mult_IZR. field.
Qed.

Lemma qzero_ok a : qzero a = true -> Q2R a = 0.
Proof. unfold qzero, Q2R. intros H. apply Z.eqb_eq in H. rewrite H. ring. Qed.

Lemma qzero_not a : qzero a = false -> Q2R a <> 0.
Proof.
  unfold qzero, Q2R. intros H. apply Z.eqb_neq in H.
  apply Rmult_integral_contrapositive_currified.
  - apply not_0_IZR, H.
  - apply Rinv_neq_0_compat, not_0_IZR. discriminate.
Qed.

Lemma qsame_ok a b : qsame a b = true -> a = b.
Proof.
  unfold qsame. destruct a, b; simpl. intros H. apply andb_prop in H as [H I].
  apply Z.eqb_eq in H. apply Pos.eqb_eq in I. congruence.
Qed.

Lemma Q2R_0 : Q2R 0 = 0. Proof. unfold Q2R; simpl; field. Qed.
Lemma Q2R_1 : Q2R 1 = 1. Proof. unfold Q2R; simpl; field. Qed.
Lemma Q2R_m1 : Q2R (-1) = -1. Proof. unfold Q2R; simpl; field. Qed.
Lemma Q2R_IZR z : Q2R (Qmake z 1) = IZR z. Proof. unfold Q2R; simpl; field. Qed.

(** * Polynomials *)

(** A number, or the coefficients c0, c1, ... of a polynomial c0 + c1 x + ... in the first variable x, which are
    polynomials in the other variables. *)
Inductive pol := C (c : Q) | P (l : list pol).

(** The value of c0 + c1 x + ... *)
Fixpoint horner (x : R) (l : list R) : R :=
  match l with [] => 0 | c :: l => c + x * horner x l end.

Fixpoint ev (p : pol) (env : list R) : R :=
  match p with
  | C c => Q2R c
  | P l => horner (hd 0 env) (map (fun c => ev c (tl env)) l)
  end.

Section Induction.
  Variable T : pol -> Prop.
  Hypothesis HC : forall c, T (C c).
  Hypothesis HP : forall l, Forall T l -> T (P l).
  Fixpoint pol_all (p : pol) : T p :=
    match p with
    | C c => HC c
    | P l => HP l ((fix all l : Forall T l :=
        match l with [] => Forall_nil T | p :: l => Forall_cons p (pol_all p) (all l) end) l)
    end.
End Induction.

(** The values of a list of coefficients. *)
Notation evs l env := (map (fun c => ev c env) l).

Definition is0 (p : pol) : bool := match p with C c => qzero c | P _ => false end.
Definition is1 (p : pol) : bool := match p with C c => qone c | P _ => false end.

(** A coefficient before others, where it is needed. *)
Definition push (c : pol) (l : list pol) : list pol :=
  match l with [] => if is0 c then [] else [c] | _ => c :: l end.
Definition mk (l : list pol) : pol :=
  match l with [] => C 0 | [C c] => C c | _ => P l end.
(** The coefficients in the first variable. *)
Definition coefs (p : pol) : list pol := match p with C c => [C c] | P l => l end.

Lemma is0_ok p env : is0 p = true -> ev p env = 0.
Proof. destruct p; simpl; [apply qzero_ok | discriminate]. Qed.

Lemma is1_ok p env : is1 p = true -> ev p env = 1.
Proof.
  destruct p as [c|]; simpl; [|discriminate]. intros H. apply andb_prop in H as [H I].
  apply Z.eqb_eq in H. apply Pos.eqb_eq in I. destruct c; simpl in *; subst. apply Q2R_1.
Qed.

Lemma push_ok c l env x : horner x (evs (push c l) env) = ev c env + x * horner x (evs l env).
Proof.
  destruct l; simpl; [|reflexivity]. destruct (is0 c) eqn:H; simpl; [|ring].
  rewrite (is0_ok _ _ H). ring.
Qed.

Lemma mk_ok l env : ev (mk l) env = horner (hd 0 env) (evs l (tl env)).
Proof.
  destruct l as [|a [|b l]]; [apply Q2R_0 | destruct a; simpl; ring | destruct a; reflexivity].
Qed.

Lemma coefs_ok p env : ev p env = horner (hd 0 env) (evs (coefs p) (tl env)).
Proof. destruct p; simpl; ring. Qed.

Arguments mk : simpl never.
Arguments push : simpl never.

Fixpoint addC (a : Q) (p : pol) : pol :=
  match p with
  | C b => C (qadd a b)
  | P [] => C a
  | P (c :: l) => mk (addC a c :: l)
  end.

Lemma addC_ok a p env : ev (addC a p) env = Q2R a + ev p env.
Proof.
  revert env. induction p as [b | l H] using pol_all; intros env; simpl.
  - apply qadd_ok.
  - destruct l as [|c l]; simpl; [ring|]. inversion H; subst.
    rewrite mk_ok. simpl. rewrite H2. ring.
Qed.

Section Zip.
  Variable f : pol -> pol -> pol.
  Fixpoint zip (l m : list pol) : list pol :=
    match l, m with
    | [], _ => m
    | _, [] => l
    | a :: l, b :: m => push (f a b) (zip l m)
    end.
End Zip.

Fixpoint add (p q : pol) : pol :=
  match p with
  | C a => addC a q
  | P l => match q with C b => addC b p | P m => mk (zip add l m) end
  end.

Lemma add_ok p q env : ev (add p q) env = ev p env + ev q env.
Proof.
  revert q env. induction p as [a | l H] using pol_all; intros q env; simpl.
  - apply addC_ok.
  - destruct q as [b | m]; [rewrite (addC_ok b (P l)); simpl; ring|].
    rewrite mk_ok. simpl. generalize (hd 0 env) as x, (tl env) as e. clear env.
    intros x e. revert m. induction H as [|a l Ha H IH]; intros m; simpl; [ring|].
    destruct m as [|b m]; simpl; [ring|]. rewrite push_ok, Ha, IH. ring.
Qed.

Fixpoint scale (c : Q) (p : pol) : pol :=
  match p with
  | C b => C (qmul c b)
  | P l => P (map (scale c) l)
  end.

Lemma scale_ok c p env : ev (scale c p) env = Q2R c * ev p env.
Proof.
  revert env. induction p as [b | l H] using pol_all; intros env; simpl.
  - apply qmul_ok.
  - rewrite map_map. generalize (hd 0 env) as x, (tl env) as e. intros x e.
    induction H as [|a l Ha H IH]; simpl; [ring|]. rewrite Ha, IH. ring.
Qed.

(** A multiple; nothing is left of a multiple by 0. *)
Definition times (c : Q) (p : pol) : pol := if qzero c then C 0 else if qone c then p else scale c p.

Lemma times_ok c p env : ev (times c p) env = Q2R c * ev p env.
Proof.
  unfold times. destruct (qzero c) eqn:H.
  - rewrite (qzero_ok _ H). simpl. rewrite Q2R_0. ring.
  - destruct (qone c) eqn:I; [|apply scale_ok].
    pose proof (is1_ok (C c) env I) as J. simpl in J. rewrite J. ring.
Qed.

Definition opp (p : pol) : pol := scale (-1) p.

Lemma opp_ok p env : ev (opp p) env = - ev p env.
Proof. unfold opp. rewrite scale_ok, Q2R_m1. ring. Qed.

Definition sub (p q : pol) : pol := add p (opp q).

Lemma sub_ok p q env : ev (sub p q) env = ev p env - ev q env.
Proof. unfold sub. rewrite add_ok, opp_ok. ring. Qed.

(** The first variable times p. *)
Definition shift (p : pol) : pol := if is0 p then p else P (C 0 :: coefs p).

Lemma shift_ok p env : ev (shift p) env = hd 0 env * ev p env.
Proof.
  unfold shift. destruct (is0 p) eqn:H.
  - rewrite (is0_ok _ _ H). ring.
  - rewrite (coefs_ok p). simpl. rewrite Q2R_0. ring.
Qed.

Fixpoint mul (p q : pol) : pol :=
  match p with
  | C c => times c q
  | P l =>
    match q with
    | C c => times c p
    | P m => (fix go l := match l with
        | [] => C 0
        | a :: l => add (mk (fold_right (fun b acc => push (mul a b) acc) [] m)) (shift (go l))
        end) l
    end
  end.

Lemma mul_ok p q env : ev (mul p q) env = ev p env * ev q env.
Proof.
  revert q env. induction p as [c | l H] using pol_all; intros q env; simpl.
  - apply times_ok.
  - destruct q as [c | m]; [rewrite times_ok; simpl; ring|].
    induction H as [|a l Ha H IH]; simpl; [rewrite Q2R_0; ring|].
    rewrite add_ok, shift_ok, mk_ok, IH. simpl.
    replace (horner (hd 0 env) (evs (fold_right (fun b acc => push (mul a b) acc) [] m) (tl env)))
      with (ev a (tl env) * horner (hd 0 env) (evs m (tl env))); [ring|].
    generalize (hd 0 env) as x. intros x. clear IH.
    induction m as [|b m IH]; simpl; [ring|]. rewrite push_ok, Ha, <- IH. ring.
Qed.

Fixpoint powp (p : pol) (n : nat) : pol :=
  match n with O => C 1 | S n => mul p (powp p n) end.

Lemma powp_ok p n env : ev (powp p n) env = ev p env ^ n.
Proof. induction n; simpl; [apply Q2R_1|]. rewrite mul_ok, IHn. reflexivity. Qed.

(** Equality of data. *)
Fixpoint same (p q : pol) : bool :=
  match p, q with
  | C a, C b => qsame a b
  | P l, P m => (fix go l m := match l, m with
      | [], [] => true
      | a :: l, b :: m => (same a b && go l m)%bool
      | _, _ => false
      end) l m
  | _, _ => false
  end.

Lemma same_ok p q : same p q = true -> p = q.
Proof.
  revert q. induction p as [a | l H] using pol_all; intros [b | m]; simpl; try discriminate.
  - intros E. f_equal. apply qsame_ok, E.
  - intros E. f_equal. revert m E. induction H as [|a l Ha H IH]; intros [|b m]; try discriminate; auto.
    intros E. apply andb_prop in E as [E F]. f_equal; auto.
Qed.

(** The variable with a number. *)
Fixpoint var (n : nat) : pol := match n with O => P [C 0; C 1] | S n => P [var n] end.

Lemma var_ok n env : ev (var n) env = nth n env 0.
Proof.
  revert env. induction n; intros env; simpl.
  - rewrite Q2R_0, Q2R_1. destruct env; simpl; ring.
  - rewrite IHn. destruct env; simpl; [destruct n|]; ring.
Qed.

(** ** Derivatives in the first variable *)

Fixpoint dl (l : list pol) : pol :=
  match l with [] => C 0 | _ :: l => add (mk l) (shift (dl l)) end.
Definition dp (p : pol) : pol := match p with C _ => C 0 | P l => dl l end.

Lemma dp_ok p x env : is_derive (fun x => ev p (x :: env)) x (ev (dp p) (x :: env)).
Proof.
  destruct p as [c | l]; simpl.
  - rewrite Q2R_0. apply (is_derive_const (V := R_NormedModule)).
  - induction l as [|c l IH]; simpl.
    + rewrite Q2R_0. apply (is_derive_const (V := R_NormedModule)).
    + rewrite add_ok, shift_ok, mk_ok. simpl.
      pose proof (is_derive_mult (K := R_AbsRing) (fun x : R => x) (fun x => horner x (evs l env)) x 1 _
        (is_derive_id (K := R_AbsRing) x) IH (fun n m => Rmult_comm n m)) as D.
      pose proof (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)
        (fun _ => ev c env) _ x _ _ (is_derive_const (V := R_NormedModule) _ _) D) as E.
      evar_last; [exact E|]. unfold plus, mult, zero; simpl. unfold plus, mult, zero; simpl. ring.
Qed.

Lemma ev_continuous p x env : continuous (fun x => ev p (x :: env)) x.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply dp_ok. Qed.

Lemma ev_stays p x env :
  ev p (x :: env) <> 0 -> locally x (fun x => ev p (x :: env) <> 0).
Proof.
  intros H. apply (ev_continuous p x env (fun u : R => u <> 0)).
  apply (open_neq 0). exact H.
Qed.

Ltac real := match goal with |- @eq _ ?a ?b => change (@eq R a b) end.

(** * Quotients *)

Record frac := F { num : pol; den : pol }.

Definition val (f : frac) (env : list R) : R := ev (num f) env / ev (den f) env.
Definition ok (f : frac) (env : list R) : Prop := ev (den f) env <> 0.
(** What every operation has to show: it is defined where its parts are, and has this value. *)
Definition is (f : frac) (env : list R) (x : R) : Prop := ok f env /\ val f env = x.

Definition fpol (p : pol) : frac := F p (C 1).

Lemma fpol_ok p env : is (fpol p) env (ev p env).
Proof.
  split; unfold ok, val; simpl; rewrite Q2R_1; [lra | field].
Qed.

Definition fadd (f g : frac) : frac :=
  if same (den f) (den g) then F (add (num f) (num g)) (den f)
  else F (add (mul (num f) (den g)) (mul (num g) (den f))) (mul (den f) (den g)).

Lemma fadd_ok f g env x y : is f env x -> is g env y -> is (fadd f g) env (x + y).
Proof.
  unfold is, ok, val, fadd. intros [Hf <-] [Hg <-].
  destruct (same (den f) (den g)) eqn:E; simpl.
  - apply same_ok in E. rewrite E in *. rewrite add_ok. split; [assumption | field; assumption].
  - rewrite add_ok, !mul_ok. split; [|field; split; assumption].
    apply Rmult_integral_contrapositive_currified; assumption.
Qed.

Definition fopp (f : frac) : frac := F (opp (num f)) (den f).

Lemma fopp_ok f env x : is f env x -> is (fopp f) env (- x).
Proof. unfold is, ok, val, fopp. intros [Hf <-]. simpl. rewrite opp_ok. split; [|field]; assumption. Qed.

Definition fmul (f g : frac) : frac := F (mul (num f) (num g)) (mul (den f) (den g)).

Lemma fmul_ok f g env x y : is f env x -> is g env y -> is (fmul f g) env (x * y).
Proof.
  unfold is, ok, val, fmul. intros [Hf <-] [Hg <-]. simpl. rewrite !mul_ok.
  split; [apply Rmult_integral_contrapositive_currified; assumption | field; split; assumption].
Qed.

Fixpoint fpow (f : frac) (n : nat) : frac :=
  match n with O => fpol (C 1) | S n => fmul f (fpow f n) end.

Lemma fpow_ok f n env x : is f env x -> is (fpow f n) env (x ^ n).
Proof.
  intros H. induction n; simpl.
  - rewrite <- Q2R_1. apply (fpol_ok (C 1)).
  - apply fmul_ok; assumption.
Qed.

(** A quotient of quotients; the divisor must not vanish. A number is divided by at once. *)
Definition fdiv (f g : frac) : frac :=
  match num g with
  | C c => if qzero c then F (mul (num f) (den g)) (mul (den f) (num g))
           else F (times (Qred (/ c)) (mul (num f) (den g))) (den f)
  | _ => F (mul (num f) (den g)) (mul (den f) (num g))
  end.

Lemma fdiv_ok f g env x y :
  is f env x -> is g env y -> ev (num g) env <> 0 -> is (fdiv f g) env (x / y).
Proof.
  unfold is, ok, val, fdiv. intros [Hf <-] [Hg <-] Hn.
  assert (G : forall n d, is (F n d) env (ev n env / ev d env) \/ ev d env = 0).
  { intros n d. destruct (Req_dec (ev d env) 0); [right | left; split]; auto. }
  destruct (num g) as [c | l] eqn:E; [destruct (qzero c) eqn:Z|]; simpl in *.
  - rewrite !mul_ok. simpl. split; [apply Rmult_integral_contrapositive_currified; assumption|].
    field. auto.
  - rewrite times_ok, mul_ok, Q2R_red, Q2R_inv; [split; [assumption | field; auto]|].
    intros H. apply Hn. rewrite (Qeq_eqR _ _ H). apply Q2R_0.
  - rewrite !mul_ok. simpl. split; [apply Rmult_integral_contrapositive_currified; assumption|].
    field. auto.
Qed.

(** A polynomial with quotients in place of its variables. *)
Fixpoint comp (p : pol) (args : list frac) : frac :=
  match p with
  | C c => fpol (C c)
  | P l => (fix h l := match l with
      | [] => fpol (C 0)
      | c :: l => fadd (comp c (tl args)) (fmul (hd (fpol (C 0)) args) (h l))
      end) l
  end.

Lemma zero_ok env : is (fpol (C 0)) env 0.
Proof. rewrite <- Q2R_0. apply (fpol_ok (C 0)). Qed.

Lemma comp_ok p args env xs :
  Forall2 (fun f x => is f env x) args xs -> is (comp p args) env (ev p xs).
Proof.
  revert args xs. induction p as [c | l H] using pol_all; intros args xs A; simpl.
  - apply (fpol_ok (C c)).
  - assert (Hd : is (hd (fpol (C 0)) args) env (hd 0 xs)).
    { destruct A; simpl; [apply zero_ok | assumption]. }
    assert (Tl : Forall2 (fun f x => is f env x) (tl args) (tl xs)).
    { destruct A; simpl; [constructor | assumption]. }
    induction H as [|c l Hc H IH]; simpl; [apply zero_ok|].
    apply fadd_ok; [apply Hc, Tl | apply fmul_ok; assumption].
Qed.

(** A quotient in place of the first variable of a polynomial. *)
Definition comp1 (p : pol) (a : frac) : frac :=
  match p with
  | C c => fpol (C c)
  | P l => fold_right (fun c acc => fadd (fpol c) (fmul a acc)) (fpol (C 0)) l
  end.

Lemma comp1_ok p a env x : is a env x -> is (comp1 p a) env (ev p (x :: env)).
Proof.
  intros H. destruct p as [c | l]; simpl; [apply (fpol_ok (C c))|].
  induction l as [|c l IH]; simpl; [apply zero_ok|].
  apply fadd_ok; [apply fpol_ok | apply fmul_ok; assumption].
Qed.

(** * Formulas *)

(** A function of real numbers with the quotient that it is wherever none of some polynomials vanishes. *)
Record fn := Fn {
  apply : list R -> R;
  quotient : frac;
  nonzero : list pol;
  fn_ok : forall env, Forall (fun c => ev c env <> 0) nonzero -> is quotient env (apply env)
}.

(** Formulas: [Var 0], [Var 1], ... are variables; [Der e a] is the derivative of e in a new variable, which is
    [Var 0] in e and before the others, where it has the value a; [Int e a b] is the integral of e in such a variable
    from a to b. *)
Inductive expr :=
  | Num (z : Z)
  | Var (n : nat)
  | Opp (e : expr)
  | Sum (a b : expr)
  | Diff (a b : expr)
  | Prod (a b : expr)
  | Quot (a b : expr)
  | Pow (e : expr) (n : nat)
  | App (f : fn) (args : list expr)
  | Der (e a : expr)
  | Int (e a b : expr).

Fixpoint eval (e : expr) (env : list R) : R :=
  match e with
  | Num z => IZR z
  | Var n => nth n env 0
  | Opp e => - eval e env
  | Sum a b => eval a env + eval b env
  | Diff a b => eval a env - eval b env
  | Prod a b => eval a env * eval b env
  | Quot a b => eval a env / eval b env
  | Pow e n => eval e env ^ n
  | App f args => apply f (map (fun a => eval a env) args)
  | Der e a => Derive (fun x => eval e (x :: env)) (eval a env)
  | Int e a b => RInt (fun x => eval e (x :: env)) (eval a env) (eval b env)
  end.

Section ExprInduction.
  Variable T : expr -> Prop.
  Hypothesis HNum : forall z, T (Num z).
  Hypothesis HVar : forall n, T (Var n).
  Hypothesis HOpp : forall e, T e -> T (Opp e).
  Hypothesis HAdd : forall a b, T a -> T b -> T (Sum a b).
  Hypothesis HSub : forall a b, T a -> T b -> T (Diff a b).
  Hypothesis HMul : forall a b, T a -> T b -> T (Prod a b).
  Hypothesis HDiv : forall a b, T a -> T b -> T (Quot a b).
  Hypothesis HPow : forall e n, T e -> T (Pow e n).
  Hypothesis HApp : forall f args, Forall T args -> T (App f args).
  Hypothesis HDer : forall e a, T e -> T a -> T (Der e a).
  Hypothesis HInt : forall e a b, T e -> T a -> T b -> T (Int e a b).
  Fixpoint expr_all (e : expr) : T e :=
    match e with
    | Num z => HNum z
    | Var n => HVar n
    | Opp e => HOpp e (expr_all e)
    | Sum a b => HAdd a b (expr_all a) (expr_all b)
    | Diff a b => HSub a b (expr_all a) (expr_all b)
    | Prod a b => HMul a b (expr_all a) (expr_all b)
    | Quot a b => HDiv a b (expr_all a) (expr_all b)
    | Pow e n => HPow e n (expr_all e)
    | App f args => HApp f args ((fix all l : Forall T l :=
        match l with [] => Forall_nil T | e :: l => Forall_cons e (expr_all e) (all l) end) args)
    | Der e a => HDer e a (expr_all e) (expr_all a)
    | Int e a b => HInt e a b (expr_all e) (expr_all a) (expr_all b)
    end.
End ExprInduction.

(** A quotient, and the polynomials that must not vanish for it to be the value of a formula. *)
Record norm_result := Res { fr : frac; cs : list pol }.

(** What must not vanish, each once; numbers that do not vanish are left out. *)
Definition trivial (p : pol) : bool := match p with C c => negb (qzero c) | P _ => false end.
Fixpoint insert (p : pol) (l : list pol) : list pol :=
  match l with [] => [p] | q :: m => if same p q then l else q :: insert p m end.
Definition join (p : pol) (l : list pol) : list pol := if trivial p then l else insert p l.
Definition joins (l m : list pol) : list pol := fold_right join m l.

Definition nz (env : list R) (c : pol) : Prop := ev c env <> 0.

Lemma insert_ok env p l : Forall (nz env) (insert p l) -> nz env p /\ Forall (nz env) l.
Proof.
  induction l as [|q l IH]; simpl; intros H.
  - inversion H; subst; auto.
  - destruct (same p q) eqn:E.
    + apply same_ok in E; subst. inversion H; subst. auto.
    + inversion H; subst. destruct (IH H3). auto.
Qed.

Lemma join_ok env p l : Forall (nz env) (join p l) -> nz env p /\ Forall (nz env) l.
Proof.
  unfold join. destruct (trivial p) eqn:E; [|apply insert_ok].
  split; auto. destruct p; simpl in *; [|discriminate].
  apply qzero_not. destruct (qzero c); [discriminate | reflexivity].
Qed.

Lemma joins_ok env l m : Forall (nz env) (joins l m) -> Forall (nz env) l /\ Forall (nz env) m.
Proof.
  induction l as [|p l IH]; simpl; intros H; [auto|].
  apply join_ok in H as [H I]. apply IH in I as [I J]. auto.
Qed.

(** The derivative of a quotient in the first variable. *)
Definition fder (f : frac) : frac :=
  if is0 (dp (den f)) then F (dp (num f)) (den f)
  else F (sub (mul (dp (num f)) (den f)) (mul (num f) (dp (den f)))) (mul (den f) (den f)).

Lemma fder_ok f x env :
  ok f (x :: env) -> is_derive (fun x => val f (x :: env)) x (val (fder f) (x :: env)) /\ ok (fder f) (x :: env).
Proof.
  unfold ok, val, fder. intros H.
  assert (D : is_derive (fun x : R => ev (num f) (x :: env) / ev (den f) (x :: env)) x
    ((ev (dp (num f)) (x :: env) * ev (den f) (x :: env) - ev (num f) (x :: env) * ev (dp (den f)) (x :: env)) /
     ev (den f) (x :: env) ^ 2)).
  { exact (is_derive_div _ _ x _ _ (dp_ok (num f) x env) (dp_ok (den f) x env) H). }
  destruct (is0 (dp (den f))) eqn:E; simpl.
  - split; [|assumption]. evar_last; [exact D|]. rewrite (is0_ok _ _ E). real. field. assumption.
  - rewrite sub_ok, !mul_ok. split.
    + evar_last; [exact D|]. real. field. assumption.
    + apply Rmult_integral_contrapositive_currified; assumption.
Qed.

(** The polynomials of [c], taken where the first variable is a. *)
Definition at_first (a : frac) (l : list pol) : list pol := map (fun c => num (comp1 c a)) l.

Lemma at_first_ok a env x l :
  is a env x -> Forall (nz env) (at_first a l) -> Forall (nz (x :: env)) l.
Proof.
  intros Ha H. induction l as [|c l IH]; constructor; inversion H; subst; auto.
  destruct (comp1_ok c a env x Ha) as [D V]. unfold nz in *. rewrite <- V. unfold val.
  apply Rmult_integral_contrapositive_currified; [assumption | apply Rinv_neq_0_compat, D].
Qed.

(** A polynomial without the first variable, in the others; nothing where the first variable occurs. *)
Definition rest (p : pol) : option pol := match coefs p with [] => Some (C 0) | [c] => Some c | _ => None end.

Lemma rest_ok p q x env : rest p = Some q -> ev p (x :: env) = ev q env.
Proof.
  unfold rest. rewrite (coefs_ok p). destruct (coefs p) as [|c [|d l]]; intros H; try discriminate;
    injection H as <-; simpl; [rewrite Q2R_0|]; ring.
Qed.

(** A polynomial without the first variable, and 0, which must not vanish and does, where the first variable occurs. *)
Definition rests (l : list pol) : list pol := map (fun c => match rest c with Some q => q | None => C 0 end) l.

Lemma rests_ok l env : Forall (nz env) (rests l) -> forall x, Forall (nz (x :: env)) l.
Proof.
  intros H x. induction l as [|c l IH]; constructor; inversion H; subst; auto.
  unfold nz in *. destruct (rest c) as [q|] eqn:E.
  - rewrite (rest_ok c q x env E). assumption.
  - simpl in *. exfalso. apply H2, Q2R_0.
Qed.

(** What has c0 + c1 x + ... as its derivative in the first variable: that it does is tested where it is used. *)
Fixpoint raised (k : positive) (l : list pol) : list pol :=
  match l with [] => [] | c :: l => times (1 # k) c :: raised (Pos.succ k) l end.
Definition primitive (p : pol) : pol := shift (mk (raised 1 (coefs p))).

(** The integral of n/d from a to b, if d does not contain the variable. *)
Definition fint (f a b : frac) : option (frac * pol) :=
  let p := primitive (num f) in
  match rest (den f) with
  | Some d => if is0 (sub (dp p) (num f))
              then Some (fdiv (fadd (comp1 p b) (fopp (comp1 p a))) (fpol d), d) else None
  | None => None
  end.

Lemma fint_ok f a b env x y r d : is a env x -> is b env y -> fint f a b = Some (r, d) -> ev d env <> 0 ->
  is_RInt (fun t => val f (t :: env)) x y (val r env) /\ ok r env.
Proof.
  unfold fint. intros Ha Hb H N. destruct (rest (den f)) as [q|] eqn:E; [|discriminate].
  destruct (is0 (sub (dp (primitive (num f))) (num f))) eqn:Z; [|discriminate]. injection H as <- <-.
  set (p := primitive (num f)) in *.
  assert (D : forall t : R, is_derive (fun t : R => ev p (t :: env) / ev q env) t (val f (t :: env))).
  { intros t. pose proof (is0_ok _ (t :: env) Z) as S. rewrite sub_ok in S. evar_last.
    - apply (is_derive_div (fun t => ev p (t :: env)) (fun _ => ev q env) t _ _ (dp_ok p t env)
        (is_derive_const (V := R_NormedModule) _ _) N).
    - unfold val. rewrite (rest_ok _ _ t env E). unfold zero; simpl.
      replace (ev (dp p) (t :: env)) with (ev (num f) (t :: env)) by lra. real. field. assumption. }
  assert (I : is_RInt (fun t => val f (t :: env)) x y (minus (G := R_AbelianGroup) (ev p (y :: env) / ev q env) (ev p (x :: env) / ev q env))).
  { apply (is_RInt_derive (V := R_CompleteNormedModule) (fun t => ev p (t :: env) / ev q env)); [intros t _; apply D|].
    intros t _. apply continuous_ext with (f := fun t => ev (num f) (t :: env) * / ev q env).
    - intros u. unfold val. rewrite (rest_ok _ _ u env E). reflexivity.
    - apply (continuous_mult (K := R_AbsRing)); [apply ev_continuous | apply continuous_const]. }
  assert (V : is (fdiv (fadd (comp1 p b) (fopp (comp1 p a))) (fpol q)) env
    ((ev p (y :: env) + - ev p (x :: env)) / ev q env)).
  { apply fdiv_ok; [apply fadd_ok; [|apply fopp_ok]; apply comp1_ok; assumption | apply fpol_ok | exact N]. }
  destruct V as [V W]. split; [|exact V]. rewrite W.
  replace ((ev p (y :: env) + - ev p (x :: env)) / ev q env)
    with (minus (ev p (y :: env) / ev q env) (ev p (x :: env) / ev q env)); [exact I|].
  unfold minus, plus, Hierarchy.opp; simpl. real. field. assumption.
Qed.

Fixpoint norm (e : expr) : norm_result :=
  match e with
  | Num z => Res (fpol (C (Qmake z 1))) []
  | Var n => Res (fpol (var n)) []
  | Opp e => let r := norm e in Res (fopp (fr r)) (cs r)
  | Sum a b => let r := norm a in let s := norm b in Res (fadd (fr r) (fr s)) (joins (cs r) (cs s))
  | Diff a b => let r := norm a in let s := norm b in Res (fadd (fr r) (fopp (fr s))) (joins (cs r) (cs s))
  | Prod a b => let r := norm a in let s := norm b in Res (fmul (fr r) (fr s)) (joins (cs r) (cs s))
  | Quot a b => let r := norm a in let s := norm b in
      Res (fdiv (fr r) (fr s)) (join (num (fr s)) (joins (cs r) (cs s)))
  | Pow e n => let r := norm e in Res (fpow (fr r) n) (cs r)
  | App f args =>
      let rs := map norm args in
      let fs := map fr rs in
      Res (fdiv (comp (num (quotient f)) fs) (comp (den (quotient f)) fs))
          (joins (map (fun c => num (comp c fs)) (nonzero f))
            (fold_right (fun r l => joins (cs r) l) [] rs))
  | Der e a =>
      let r := norm e in let s := norm a in
      let d := fder (fr r) in
      Res (fdiv (comp1 (num d) (fr s)) (comp1 (den d) (fr s))) (joins (at_first (fr s) (cs r)) (cs s))
  | Int e a b =>
      let r := norm e in let s := norm a in let t := norm b in
      match fint (fr r) (fr s) (fr t) with
      | Some (f, d) => Res f (join d (joins (rests (cs r)) (joins (cs s) (cs t))))
      | None => Res (fpol (C 0)) [C 0]
      end
  end.

Lemma numerator_not f env x : is f env x -> x <> 0 -> ev (num f) env <> 0.
Proof.
  intros [D V] H E. apply H. rewrite <- V. unfold val. rewrite E. unfold Rdiv. ring.
Qed.

Lemma forall_apart env (l : list pol) (m : list frac) xs :
  Forall2 (fun f x => is f env x) m xs ->
  Forall (nz env) (map (fun c => num (comp c m)) l) -> Forall (nz xs) l.
Proof.
  intros A H. induction l as [|c l IH]; constructor; inversion H; subst; auto.
  destruct (comp_ok c m env xs A) as [D V]. unfold nz in *. rewrite <- V. unfold val.
  apply Rmult_integral_contrapositive_currified; [assumption | apply Rinv_neq_0_compat, D].
Qed.

Lemma forall_locally {A} (Q : A -> R -> Prop) (l : list A) x :
  Forall (fun c => locally x (Q c)) l -> locally x (fun y => Forall (fun c => Q c y) l).
Proof.
  intros H. induction H as [|c l Hc H IH].
  - apply filter_forall. intros; constructor.
  - generalize (filter_and _ _ Hc IH). apply filter_imp. intros y [? ?]. constructor; assumption.
Qed.

(** A formula has a derivative, that of its quotient. *)
Lemma der_ok e x env :
  (forall env, Forall (nz env) (cs (norm e)) -> is (fr (norm e)) env (eval e env)) ->
  Forall (nz (x :: env)) (cs (norm e)) ->
  is_derive (fun x => eval e (x :: env)) x (val (fder (fr (norm e))) (x :: env)) /\
  ok (fder (fr (norm e))) (x :: env).
Proof.
  intros IH H. destruct (IH _ H) as [D _]. destruct (fder_ok _ _ _ D) as [D1 D2]. split; [|exact D2].
  apply is_derive_ext_loc with (f := fun x => val (fr (norm e)) (x :: env)); [|exact D1].
  assert (L : locally x (fun x => Forall (fun c => nz (x :: env) c) (cs (norm e)))).
  { apply forall_locally with (Q := fun c x => nz (x :: env) c).
    revert H. apply Forall_impl. intros c. apply ev_stays. }
  revert L. apply filter_imp. intros y Hy. apply IH, Hy.
Qed.

(** A formula has an integral, that of its quotient. *)
Lemma int_ok e a b x y r d env :
  (forall env, Forall (nz env) (cs (norm e)) -> is (fr (norm e)) env (eval e env)) ->
  is a env x -> is b env y -> fint (fr (norm e)) a b = Some (r, d) -> ev d env <> 0 ->
  Forall (nz env) (rests (cs (norm e))) ->
  is_RInt (fun t => eval e (t :: env)) x y (val r env) /\ ok r env.
Proof.
  intros IH Ha Hb E N H. destruct (fint_ok _ _ _ _ _ _ _ _ Ha Hb E N) as [I K]. split; [|exact K].
  apply is_RInt_ext with (f := fun t => val (fr (norm e)) (t :: env)); [|exact I].
  intros t _. apply IH, rests_ok, H.
Qed.

(** The quotient of a formula is its value wherever nothing vanishes that must not. *)
Theorem norm_ok e : forall env, Forall (nz env) (cs (norm e)) -> is (fr (norm e)) env (eval e env).
Proof.
  induction e as [z | n | e IH | a b IHa IHb | a b IHa IHb | a b IHa IHb | a b IHa IHb | e n IH
                 | f args IH | e a IHe IHa | e a b IHe IHa IHb] using expr_all; intros env H; simpl in *.
  - rewrite <- Q2R_IZR. apply (fpol_ok (C _)).
  - rewrite <- var_ok. apply fpol_ok.
  - apply fopp_ok, IH, H.
  - apply joins_ok in H as [? ?]. apply fadd_ok; auto.
  - apply joins_ok in H as [? ?]. unfold Rminus. apply fadd_ok; [|apply fopp_ok]; auto.
  - apply joins_ok in H as [? ?]. apply fmul_ok; auto.
  - apply join_ok in H as [? H]. apply joins_ok in H as [? ?]. apply fdiv_ok; auto.
  - apply fpow_ok; auto.
  - apply joins_ok in H as [H I].
    assert (A : Forall2 (fun f x => is f env x) (map fr (map norm args)) (map (fun a => eval a env) args)).
    { clear H. induction IH as [|e args He IH]; simpl in *; constructor.
      - apply joins_ok in I as [? ?]. auto.
      - apply joins_ok in I as [? ?]. auto. }
    apply (forall_apart _ _ _ _ A) in H. destruct (fn_ok f _ H) as [D V]. rewrite <- V. unfold val.
    apply fdiv_ok; [apply comp_ok, A | apply comp_ok, A |].
    eapply numerator_not; [apply comp_ok, A | exact D].
  - apply joins_ok in H as [H I]. specialize (IHa env I).
    apply (at_first_ok _ _ _ _ IHa) in H. destruct (der_ok e _ _ IHe H) as [D K].
    assert (V : Derive (fun x : R => eval e (x :: env)) (eval a env) =
      val (fder (fr (norm e))) (eval a env :: env)) by exact (is_derive_unique _ _ _ D).
    rewrite V. unfold val.
    apply fdiv_ok; [apply comp1_ok, IHa | apply comp1_ok, IHa |].
    eapply numerator_not; [apply comp1_ok, IHa | exact K].
  - destruct (fint (fr (norm e)) (fr (norm a)) (fr (norm b))) as [[f d]|] eqn:E; simpl in *.
    + apply join_ok in H as [N H]. apply joins_ok in H as [H I]. apply joins_ok in I as [I J].
      destruct (int_ok e _ _ _ _ _ _ env IHe (IHa env I) (IHb env J) E N H) as [D K].
      split; [exact K | symmetry; apply is_RInt_unique, D].
    + exfalso. inversion H; subst. apply H2. simpl. apply Q2R_0.
Qed.

(** * Signs *)

(** An end of a range: none, or a number that belongs to the range or does not. *)
Inductive bound := Inf | Incl (q : Q) | Excl (q : Q).
Definition range := (bound * bound)%type.

Definition above (b : bound) (x : R) : Prop :=
  match b with Inf => True | Incl q => Q2R q <= x | Excl q => Q2R q < x end.
Definition below (b : bound) (x : R) : Prop :=
  match b with Inf => True | Incl q => x <= Q2R q | Excl q => x < Q2R q end.

(** Every variable is in its range. *)
Fixpoint inbox (rs : list range) (env : list R) : Prop :=
  match rs with
  | [] => True
  | r :: rs => (above (fst r) (hd 0 env) /\ below (snd r) (hd 0 env)) /\ inbox rs (tl env)
  end.

(** What is claimed of a number: that it is positive, or that it is not negative. *)
Definition sign (strict : bool) (x : R) : Prop := if strict then 0 < x else 0 <= x.

Lemma sign_weak s x : sign s x -> 0 <= x.
Proof. destruct s; simpl; lra. Qed.

(** ** Bernstein coefficients *)

(** The value of sum c_j y^j z^(n-j). *)
Fixpoint hev (y z : R) (l : list R) : R :=
  match l with [] => 0 | c :: l => c * z ^ length l + y * hev y z l end.

(** (al z + be y) times such a sum. *)
Fixpoint lin (al be : Q) (prev : pol) (w : list pol) : list pol :=
  match w with
  | [] => [times be prev]
  | c :: w => add (times al c) (times be prev) :: lin al be c w
  end.

Lemma lin_length al be prev w : length (lin al be prev w) = S (length w).
Proof. revert prev. induction w; intros; simpl; auto. Qed.

Lemma lin_ok al be w y z env : forall prev,
  hev y z (evs (lin al be prev w) env) =
  Q2R be * ev prev env * z ^ length w + (Q2R al * z + Q2R be * y) * hev y z (evs w env).
Proof.
  induction w as [|c w IH]; intros prev; simpl.
  - rewrite times_ok. ring.
  - rewrite add_ok, !times_ok, IH, !map_length, lin_length. simpl. ring.
Qed.

Lemma lin0 al be w y z env :
  hev y z (evs (lin al be (C 0) w) env) = (Q2R al * z + Q2R be * y) * hev y z (evs w env).
Proof. rewrite lin_ok. simpl. rewrite Q2R_0. ring. Qed.

Fixpoint ladd (l m : list pol) : list pol :=
  match l, m with a :: l, b :: m => add a b :: ladd l m | _, _ => [] end.

Lemma ladd_length l m : length l = length m -> length (ladd l m) = length m.
Proof. revert m. induction l; intros [|b m]; simpl; intros E; auto; discriminate E. Qed.

Lemma ladd_ok l m y z env : length l = length m ->
  hev y z (evs (ladd l m) env) = hev y z (evs l env) + hev y z (evs m env).
Proof.
  revert m. induction l as [|a l IH]; intros [|b m]; simpl; intros E; try discriminate E; [ring|].
  injection E as E. rewrite add_ok, IH, !map_length, ladd_length, E by assumption. ring.
Qed.

Lemma hev_mul p l y z env :
  hev y z (evs (map (mul p) l) env) = ev p env * hev y z (evs l env).
Proof. induction l as [|a l IH]; simpl; [ring|]. rewrite mul_ok, IH, !map_length. ring. Qed.

(** With x = (a z + b y)/(y + z) the coefficients of (y + z)^n and of (y + z)^(n-1) (c0 + c1 x + ...), where n is the
    number of the c's. *)
Fixpoint hom (a b : Q) (l : list pol) : list pol * list pol :=
  match l with
  | [] => ([C 1], [])
  | c :: l => let (w, h) := hom a b l in (lin 1 1 (C 0) w, ladd (map (mul c) w) (lin a b (C 0) h))
  end.

Lemma hom_length a b l :
  length (fst (hom a b l)) = S (length l) /\ length (snd (hom a b l)) = length l.
Proof.
  induction l as [|c l [IH1 IH2]]; simpl; [auto|]. destruct (hom a b l) as [w h]; simpl in *.
  rewrite lin_length, ladd_length; rewrite ?lin_length, ?map_length; lia.
Qed.

Lemma hom_ok a b l x y z env : x * (y + z) = Q2R a * z + Q2R b * y ->
  hev y z (evs (fst (hom a b l)) env) = (y + z) ^ length l /\
  (y + z) * hev y z (evs (snd (hom a b l)) env) = (y + z) ^ length l * horner x (evs l env).
Proof.
  intros E. induction l as [|c l [IH1 IH2]]; simpl; [rewrite Q2R_1; split; ring|].
  pose proof (hom_length a b l) as [L1 L2]. destruct (hom a b l) as [w h]; simpl in *.
  rewrite lin0, ladd_ok, hev_mul, lin0, Q2R_1, IH1 by (rewrite lin_length, map_length; lia).
  rewrite <- E. split; [ring|].
  replace ((y + z) * (ev c env * (y + z) ^ length l + x * (y + z) * hev y z (evs h env)))
    with ((y + z) * ev c env * (y + z) ^ length l + x * (y + z) * ((y + z) * hev y z (evs h env))) by ring.
  rewrite IH2. ring.
Qed.

(** With x = a + b y the coefficients of c0 + c1 x + ... in y. *)
Fixpoint taylor (a b : Q) (l : list pol) : list pol :=
  match l with
  | [] => []
  | c :: l => match lin a b (C 0) (taylor a b l) with d :: m => add c d :: m | [] => [] end
  end.

Lemma hev_1 y l : hev y 1 l = horner y l.
Proof. induction l; simpl; [ring|]. rewrite IHl, pow1. ring. Qed.

Lemma taylor_ok a b l y env :
  horner y (evs (taylor a b l) env) = horner (Q2R a + Q2R b * y) (evs l env).
Proof.
  induction l as [|c l IH]; simpl; [reflexivity|].
  pose proof (lin0 a b (taylor a b l) y 1 env) as H. pose proof (lin_length a b (C 0) (taylor a b l)) as L.
  destruct (lin a b (C 0) (taylor a b l)) as [|d m]; [discriminate L|].
  rewrite !hev_1 in H. rewrite IH in H. simpl in *. rewrite add_ok. rewrite <- (Rmult_1_r (Q2R a)) at 1. lra.
Qed.

Definition first (l : list pol) : pol := hd (C 0) l.
Definition total (l : list pol) : pol := fold_right add (C 0) l.

Lemma hev_weak l y z env :
  0 <= y -> 0 <= z -> Forall (fun c => 0 <= ev c env) l -> 0 <= hev y z (evs l env).
Proof.
  intros Hy Hz H. induction H; simpl; [lra|].
  apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto. apply pow_le, Hz.
Qed.

Lemma hev_first l y z env :
  0 <= y -> 0 < z -> Forall (fun c => 0 <= ev c env) l -> 0 < ev (first l) env -> 0 < hev y z (evs l env).
Proof.
  intros Hy Hz H. destruct H as [|c l Hc H]; simpl; [rewrite Q2R_0; lra|]. intros Hf.
  apply Rplus_lt_le_0_compat; [apply Rmult_lt_0_compat; [assumption | apply pow_lt, Hz]|].
  apply Rmult_le_pos; [assumption | apply hev_weak; auto; lra].
Qed.

Lemma hev_last l y z env :
  0 < y -> 0 <= z -> Forall (fun c => 0 <= ev c env) l -> 0 < ev (last l (C 0)) env ->
  0 < hev y z (evs l env).
Proof.
  intros Hy Hz H. induction H as [|c l Hc H IH]; [simpl; rewrite Q2R_0; lra|]. intros Hl.
  destruct l as [|d l]; [simpl in *; lra|]. change (last (c :: d :: l) (C 0)) with (last (d :: l) (C 0)) in Hl.
  specialize (IH Hl).
  change (0 < ev c env * z ^ length (evs (d :: l) env) + y * hev y z (evs (d :: l) env)).
  apply Rplus_le_lt_0_compat; [apply Rmult_le_pos; [assumption | apply pow_le, Hz]|].
  apply Rmult_lt_0_compat; assumption.
Qed.

Lemma hev_total l y z env :
  0 < y -> 0 < z -> Forall (fun c => 0 <= ev c env) l -> 0 < ev (total l) env -> 0 < hev y z (evs l env).
Proof.
  intros Hy Hz H. induction H as [|c l Hc H IH]; simpl; [rewrite Q2R_0; lra|]. rewrite add_ok. intros Ht.
  pose proof (hev_weak l y z env (Rlt_le _ _ Hy) (Rlt_le _ _ Hz) H) as W.
  pose proof (pow_lt z (length (evs l env)) Hz) as Z.
  destruct (Rle_lt_or_eq_dec _ _ Hc) as [G | G].
  - apply Rplus_lt_le_0_compat; [apply Rmult_lt_0_compat; assumption|]. apply Rmult_le_pos; lra.
  - rewrite <- G in *. rewrite Rmult_0_l, Rplus_0_l. apply Rmult_lt_0_compat; [assumption|]. apply IH. lra.
Qed.

(** ** The sign of a polynomial on a box *)

Definition qlt (a b : Q) : bool := negb (Qle_bool b a).

Lemma qlt_ok a b : qlt a b = true -> Q2R a < Q2R b.
Proof.
  unfold qlt. intros H. apply Qlt_Rlt. apply Qnot_le_lt. intros L. apply Qle_bool_iff in L.
  rewrite L in H. discriminate.
Qed.

(** c0 + c1 a + ... *)
Definition at_number (a : Q) (l : list pol) : pol := fold_right (fun c acc => add c (times a acc)) (C 0) l.

Lemma at_number_ok a l env : ev (at_number a l) env = horner (Q2R a) (evs l env).
Proof. induction l; simpl; [apply Q2R_0|]. rewrite add_ok, times_ok, IHl. reflexivity. Qed.

Definition is_incl (b : bound) : bool := match b with Incl _ => true | _ => false end.

Section OneVariable.
  (** What decides about the coefficients, which are polynomials in the other variables. *)
  Variable rest : bool -> pol -> bool.

  (** Nonnegative coefficients, first and last one for the two ends. *)
  Definition ends (s lo hi : bool) (w : list pol) : bool :=
    (forallb (rest false) w &&
      if s then
        match lo, hi with
        | true, true => rest true (first w) && rest true (last w (C 0))
        | true, false => rest true (first w)
        | false, true => rest true (last w (C 0))
        | false, false => rest true (total w)
        end
      else true)%bool.

  Definition side (s : bool) (lo hi : bound) (l : list pol) : bool :=
    match lo, hi with
    | Incl a, Incl b | Incl a, Excl b | Excl a, Incl b | Excl a, Excl b =>
        if qlt a b then ends s (is_incl lo) (is_incl hi) (snd (hom a b l))
        else (qsame a b && rest s (at_number a l))%bool
    | Incl a, Inf | Excl a, Inf => ends s (is_incl lo) false (taylor a 1 l)
    | Inf, Incl b | Inf, Excl b => ends s (is_incl hi) false (taylor b (-1) l)
    | Inf, Inf => false
    end.

  Variable env : list R.
  Hypothesis rest_ok : forall s p, rest s p = true -> sign s (ev p env).

  Lemma ends_ok s lo hi w y z :
    ends s lo hi w = true ->
    0 <= y -> 0 <= z -> 0 < y + z -> (lo = false -> 0 < y) -> (hi = false -> 0 < z) ->
    sign s (hev y z (evs w env)).
  Proof.
    unfold ends. intros H Hy Hz Hyz Hlo Hhi. apply andb_prop in H as [H S].
    assert (W : Forall (fun c => 0 <= ev c env) w).
    { apply Forall_forall. intros c Hc. rewrite forallb_forall in H. exact (rest_ok false c (H c Hc)). }
    destruct s; simpl; [|apply hev_weak; assumption].
    destruct lo, hi.
    - apply andb_prop in S as [S1 S2]. apply rest_ok in S1, S2. simpl in S1, S2.
      destruct (Rle_lt_or_eq_dec _ _ Hz) as [G | G]; [apply hev_first; auto|].
      apply hev_last; auto; lra.
    - apply rest_ok in S. apply hev_first; auto.
    - apply rest_ok in S. apply hev_last; auto.
    - apply rest_ok in S. apply hev_total; auto.
  Qed.

  Lemma sign_scale s c x : 0 < c -> sign s (c * x) -> sign s x.
  Proof.
    destruct s; simpl; intros Hc H.
    - apply (Rmult_lt_reg_l c); lra.
    - apply (Rmult_le_reg_l c); lra.
  Qed.

  Lemma finite_ok s lo hi a b l x : Q2R a < Q2R b ->
    ends s lo hi (snd (hom a b l)) = true ->
    Q2R a <= x <= Q2R b -> (lo = false -> Q2R a < x) -> (hi = false -> x < Q2R b) ->
    sign s (horner x (evs l env)).
  Proof.
    intros Hab H Hx Hlo Hhi.
    assert (E : x * (x - Q2R a + (Q2R b - x)) = Q2R a * (Q2R b - x) + Q2R b * (x - Q2R a)) by ring.
    destruct (hom_ok a b l x _ _ env E) as [_ V].
    assert (S : sign s (hev (x - Q2R a) (Q2R b - x) (evs (snd (hom a b l)) env))).
    { apply (ends_ok s lo hi); auto; try lra; intros G; [apply Hlo in G | apply Hhi in G]; lra. }
    apply (sign_scale s ((x - Q2R a + (Q2R b - x)) ^ length l)); [apply pow_lt; lra|].
    rewrite <- V. destruct s; simpl in *.
    - apply Rmult_lt_0_compat; lra.
    - apply Rmult_le_pos; lra.
  Qed.

  Lemma half_ok s inc a b l y :
    ends s inc false (taylor a b l) = true -> 0 <= y -> (inc = false -> 0 < y) ->
    sign s (horner (Q2R a + Q2R b * y) (evs l env)).
  Proof.
    intros H Hy Hi. rewrite <- taylor_ok, <- hev_1. apply (ends_ok s inc false); auto; lra.
  Qed.

  Lemma side_ok s lo hi l x :
    side s lo hi l = true -> above lo x -> below hi x -> sign s (horner x (evs l env)).
  Proof.
    assert (HF : forall s lo hi a b,
      (if qlt a b then ends s lo hi (snd (hom a b l)) else (qsame a b && rest s (at_number a l))%bool) = true ->
      Q2R a <= x <= Q2R b -> (lo = false -> Q2R a < x) -> (hi = false -> x < Q2R b) ->
      sign s (horner x (evs l env))).
    { clear s lo hi. intros s lo hi a b H Hx Hlo Hhi. destruct (qlt a b) eqn:Q.
      - apply (finite_ok s lo hi a b); auto. apply qlt_ok, Q.
      - apply andb_prop in H as [E H]. apply qsame_ok in E. subst b.
        replace x with (Q2R a) by lra. rewrite <- at_number_ok. apply rest_ok, H. }
    assert (HL : forall s inc a, ends s inc false (taylor a 1 l) = true ->
      Q2R a <= x -> (inc = false -> Q2R a < x) -> sign s (horner x (evs l env))).
    { intros s' inc a H Hx Hi. replace x with (Q2R a + Q2R 1 * (x - Q2R a)) by (rewrite Q2R_1; ring).
      apply (half_ok s' inc); auto; [lra|]. intros G. apply Hi in G. lra. }
    assert (HR : forall s inc b, ends s inc false (taylor b (-1) l) = true ->
      x <= Q2R b -> (inc = false -> x < Q2R b) -> sign s (horner x (evs l env))).
    { intros s' inc b H Hx Hi. replace x with (Q2R b + Q2R (-1) * (Q2R b - x)) by (rewrite Q2R_m1; ring).
      apply (half_ok s' inc); auto; [lra|]. intros G. apply Hi in G. lra. }
    destruct lo as [|a|a], hi as [|b|b]; simpl; intros H A B; try discriminate H.
    - apply (HR s true b); auto; discriminate.
    - apply (HR s false b); auto; lra.
    - apply (HL s true a); auto; discriminate.
    - apply (HF s true true a b); auto; discriminate.
    - apply (HF s true false a b); auto; try lra; discriminate.
    - apply (HL s false a); auto; lra.
    - apply (HF s false true a b); auto; try lra; discriminate.
    - apply (HF s false false a b); auto; lra.
  Qed.
End OneVariable.

(** The number of coefficients in each variable, of all coefficients in the variables before. *)
Fixpoint maxs (l m : list nat) : list nat :=
  match l, m with [], _ => m | _, [] => l | a :: l, b :: m => Nat.max a b :: maxs l m end.
Fixpoint lengths (p : pol) : list nat :=
  match p with C _ => [] | P l => length l :: fold_right (fun c acc => maxs (lengths c) acc) [] l end.

(** Coefficients with zeros behind them, up to a number of them: those of a higher degree. *)
Definition pad (n : nat) (l : list pol) : list pol := l ++ repeat (C 0) (n - length l).

Lemma pad_ok n l x env : horner x (evs (pad n l) env) = horner x (evs l env).
Proof.
  unfold pad. induction l as [|c l IH] in n |- *; simpl.
  - induction (n - 0)%nat as [|k IH]; simpl; [reflexivity|]. rewrite IH, Q2R_0. ring.
  - specialize (IH (pred n)). replace (n - S (length l))%nat with (pred n - length l)%nat by lia. rewrite IH. reflexivity.
Qed.

(** Whether the coefficients show that p has the sign on the box: those of the degrees that polynomials have, or of higher
    ones, by the numbers of coefficients that are given. *)
Fixpoint decide (ns : list nat) (rs : list range) (s : bool) (p : pol) : bool :=
  match p with
  | C c => if s then qlt 0 c else Qle_bool 0 c
  | P l =>
    match rs with
    | [] => false
    | (lo, hi) :: rs =>
      match l with
      | [c] => decide (tl ns) rs s c
      | _ =>
        match lo, hi with
        | Inf, Inf => (side (decide (tl ns) rs) s Inf (Incl 0) (pad (hd O ns) l) &&
                       side (decide (tl ns) rs) s (Incl 0) Inf (pad (hd O ns) l))%bool
        | _, _ => side (decide (tl ns) rs) s lo hi (pad (hd O ns) l)
        end
      end
    end
  end.

Lemma decide_ok rs : forall ns s p env, decide ns rs s p = true -> inbox rs env -> sign s (ev p env).
Proof.
  assert (HC : forall (s : bool) c env, (if s then qlt 0 c else Qle_bool 0 c) = true -> sign s (ev (C c) env)).
  { intros s c env H; destruct s; simpl; rewrite <- Q2R_0; [apply qlt_ok, H | apply Qle_Rle, Qle_bool_iff, H]. }
  induction rs as [|[lo hi] rs IH]; intros ns s [c | l] env H B;
    try (apply HC; exact H); [discriminate H|].
  destruct B as [[A B] T]; simpl in A, B.
  set (m := pad (hd O ns) l) in *.
  assert (G : forall lo hi, side (decide (tl ns) rs) s lo hi m = true -> above lo (hd 0 env) -> below hi (hd 0 env) ->
    sign s (ev (P l) env)).
  { intros lo' hi' H' A' B'. change (sign s (horner (hd 0 env) (evs l (tl env)))). rewrite <- (pad_ok (hd O ns)).
    apply (side_ok (decide (tl ns) rs)) with (lo := lo') (hi := hi'); auto. intros s' p' D. apply (IH _ _ _ _ D), T. }
  assert (G2 : match lo, hi with
    | Inf, Inf => (side (decide (tl ns) rs) s Inf (Incl 0) m && side (decide (tl ns) rs) s (Incl 0) Inf m)%bool
    | _, _ => side (decide (tl ns) rs) s lo hi m end = true -> sign s (ev (P l) env)).
  { intros H'. destruct lo, hi; try (apply (G _ _ H'); assumption).
    apply andb_prop in H' as [H1 H2]. destruct (Rle_dec (hd 0 env) 0) as [L | L].
    - apply (G _ _ H1); simpl; rewrite ?Q2R_0; auto.
    - apply (G _ _ H2); simpl; rewrite ?Q2R_0; auto. lra. }
  destruct l as [|c [|d l]].
  - apply G2. destruct lo, hi; exact H.
  - replace (ev (P [c]) env) with (ev c (tl env)) by (simpl; ring). apply (IH (tl ns)); [exact H | exact T].
  - apply G2. destruct lo, hi; exact H.
Qed.

(** How to show a sign: by the coefficients; on both parts of a box that is cut where a variable is q; of a product
    from the signs of its factors, both positive or both negative; of a square times another; of a sum in which one
    summand is a square times a positive number; of a polynomial of degree 1 in a variable from its values at the ends
    of the range, at an infinite one from the slope. *)
Inductive cert :=
  | Direct
  | Cut (k : nat) (q : Q) (low high : cert)
  | Product (negative : bool) (f g : pol) (cf cg : cert)
  | Square (f g : pol) (c : cert)
  | Plus (q : Q) (f : pol) (c : cert)
  | Corner (k : nat) (low high : cert).

Fixpoint set_high (k : nat) (q : Q) (rs : list range) : list range :=
  match k, rs with
  | _, [] => []
  | O, (lo, _) :: rs => (lo, Incl q) :: rs
  | S k, r :: rs => r :: set_high k q rs
  end.
Fixpoint set_low (k : nat) (q : Q) (rs : list range) : list range :=
  match k, rs with
  | _, [] => []
  | O, (_, hi) :: rs => (Incl q, hi) :: rs
  | S k, r :: rs => r :: set_low k q rs
  end.

(** A polynomial where a variable is q, as one in the same variables. *)
Fixpoint at_var (k : nat) (q : Q) (p : pol) : pol :=
  match p with
  | C c => C c
  | P l => match k with O => P [at_number q l] | S k => P (map (at_var k q) l) end
  end.

(** With p = a + b x, where x is a variable: whether an end of its range shows its part of the sign. *)
Definition corner (decides : bool -> pol -> bool) (s : bool) (a b : pol) (e : bound) (outwards : pol) : bool :=
  match e with
  | Incl q => decides s (add a (times q b))
  | Excl q => decides false (add a (times q b))
  | Inf => decides false outwards
  end.

Fixpoint check (c : cert) (rs : list range) (s : bool) (p : pol) : bool :=
  match c with
  | Direct => (decide [] rs s p || decide (lengths p) rs s p)%bool
  | Cut k q low high => (check low (set_high k q rs) s p && check high (set_low k q rs) s p)%bool
  | Product n f g cf cg =>
      (is0 (sub p (mul f g)) && check cf rs s (if n then opp f else f) && check cg rs s (if n then opp g else g))%bool
  | Square f g c => (negb s && is0 (sub p (mul (mul f f) g)) && check c rs false g)%bool
  | Plus q f c => (qlt 0 q && check c rs s (sub p (times q (mul f f))))%bool
  | Corner k low high =>
      let a := at_var k 0 p in
      let b := sub (at_var k 1 p) a in
      match nth_error rs k with
      | Some (lo, hi) =>
          (is0 (sub p (add a (mul (var k) b))) && (negb s || is_incl lo || is_incl hi) &&
           negb (match lo, hi with Inf, Inf => true | _, _ => false end) &&
           corner (check low rs) s a b lo (opp b) && corner (check high rs) s a b hi b)%bool
      | None => false
      end
  end.

Lemma set_ok k q rs env :
  inbox rs env -> inbox (set_high k q rs) env \/ inbox (set_low k q rs) env.
Proof.
  revert rs env. induction k as [|k IH]; intros [|[lo hi] rs] env; simpl; auto.
  - intros [[A B] T]. destruct (Rle_dec (hd 0 env) (Q2R q)); [left | right]; repeat split; auto; lra.
  - intros [AB T]. destruct (IH _ _ T); auto.
Qed.

Lemma inbox_nth k : forall rs env lo hi,
  nth_error rs k = Some (lo, hi) -> inbox rs env -> above lo (nth k env 0) /\ below hi (nth k env 0).
Proof.
  induction k as [|k IH]; intros [|r rs] env lo hi N B; simpl in N; try discriminate N; destruct B as [A T].
  - injection N as ->. destruct env; exact A.
  - specialize (IH rs (tl env) lo hi N T). destruct env; simpl in *; [destruct k|]; exact IH.
Qed.

(** Between its values at the ends, or with a slope that leads upwards, a + b x has their sign. *)
Lemma corner_ok (decides1 decides2 : bool -> pol -> bool) (s : bool) (a b : pol) env x lo hi :
  (forall s p, decides1 s p = true -> sign s (ev p env)) ->
  (forall s p, decides2 s p = true -> sign s (ev p env)) ->
  (negb s || is_incl lo || is_incl hi = true)%bool ->
  negb (match lo, hi with Inf, Inf => true | _, _ => false end) = true ->
  corner decides1 s a b lo (opp b) = true -> corner decides2 s a b hi b = true ->
  above lo x -> below hi x -> sign s (ev a env + x * ev b env).
Proof.
  intros D1 D2 S F L H A B.
  assert (G : forall l h vl vh, l <= x <= h -> vl = ev a env + l * ev b env -> vh = ev a env + h * ev b env ->
    0 <= vl -> 0 <= vh -> 0 <= ev a env + x * ev b env).
  { intros l h vl vh X -> -> U V. destruct (Rle_dec 0 (ev b env)); nra. }
  assert (G' : forall l h vl vh, l <= x <= h -> vl = ev a env + l * ev b env -> vh = ev a env + h * ev b env ->
    0 <= vl -> 0 <= vh -> (0 < vl /\ x < h \/ 0 < vh /\ l < x \/ 0 < vl /\ 0 < vh) -> 0 < ev a env + x * ev b env).
  { intros l h vl vh X -> -> U V W. destruct (Rle_dec 0 (ev b env)) as [P | P].
    - destruct W as [[W Y] | [[W Y] | [W Y]]]; [nra| |nra]. destruct (Req_dec (ev b env) 0) as [Z | Z]; [rewrite Z in *; lra | nra].
    - destruct W as [[W Y] | [[W Y] | [W Y]]]; nra. }
  destruct lo as [|l|l], hi as [|h|h]; simpl in *; try discriminate F;
    try apply D1 in L; try apply D2 in H; rewrite ?opp_ok, ?add_ok, ?times_ok in *;
    destruct s; simpl in *; try discriminate S; try nra.
  all: pose (vl := ev a env + Q2R l * ev b env); pose (vh := ev a env + Q2R h * ev b env).
  all: try (apply (G (Q2R l) (Q2R h) vl vh); [lra | reflexivity | reflexivity | unfold vl; lra | unfold vh; lra]).
  all: apply (G' (Q2R l) (Q2R h) vl vh);
    [lra | reflexivity | reflexivity | unfold vl; lra | unfold vh; lra | unfold vl, vh; lra].
Qed.

Lemma check_ok c : forall rs s p env, check c rs s p = true -> inbox rs env -> sign s (ev p env).
Proof.
  induction c as [|k q low IHl high IHh | n f g cf IHf cg IHg | f g c IH | q f c IH | k low IHl high IHh];
    intros rs s p env H B; simpl in H.
  - apply orb_prop in H as [H | H]; eapply decide_ok; eassumption.
  - apply andb_prop in H as [H1 H2]. destruct (set_ok k q rs env B); eauto.
  - apply andb_prop in H as [H H3]. apply andb_prop in H as [H1 H2].
    apply (is0_ok _ env) in H1. rewrite sub_ok, mul_ok in H1.
    specialize (IHf _ _ _ env H2 B). specialize (IHg _ _ _ env H3 B).
    replace (ev p env) with (ev f env * ev g env) by lra.
    destruct n; rewrite ?opp_ok in *; destruct s; simpl in *.
    + replace (ev f env * ev g env) with (- ev f env * - ev g env) by ring. apply Rmult_lt_0_compat; lra.
    + replace (ev f env * ev g env) with (- ev f env * - ev g env) by ring. apply Rmult_le_pos; lra.
    + apply Rmult_lt_0_compat; lra.
    + apply Rmult_le_pos; lra.
  - apply andb_prop in H as [H H3]. apply andb_prop in H as [H1 H2]. destruct s; [discriminate H1|].
    apply (is0_ok _ env) in H2. rewrite sub_ok, !mul_ok in H2.
    specialize (IH _ _ _ env H3 B). simpl in *.
    replace (ev p env) with (ev f env * ev f env * ev g env) by lra.
    apply Rmult_le_pos; [apply Rle_0_sqr | assumption].
  - apply andb_prop in H as [H1 H2]. apply qlt_ok in H1. rewrite Q2R_0 in H1.
    specialize (IH _ _ _ env H2 B). rewrite sub_ok, times_ok, mul_ok in IH.
    assert (S : 0 <= Q2R q * (ev f env * ev f env)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
    destruct s; simpl in *; lra.
  - destruct (nth_error rs k) as [[lo hi]|] eqn:N; [|discriminate H].
    apply andb_prop in H as [H H5]. apply andb_prop in H as [H H4]. apply andb_prop in H as [H H3].
    apply andb_prop in H as [H1 H2]. destruct (inbox_nth k rs env lo hi N B) as [X Y].
    apply (is0_ok _ env) in H1. rewrite sub_ok, add_ok, mul_ok, var_ok in H1.
    replace (ev p env) with
      (ev (at_var k 0 p) env + nth k env 0 * ev (sub (at_var k 1 p) (at_var k 0 p)) env) by lra.
    apply (corner_ok (check low rs) (check high rs) s _ _ env _ lo hi); try assumption;
      intros s' p' G; [apply (IHl rs) | apply (IHh rs)]; assumption.
Qed.

(** * What theorems are proved by *)

(** Whether a polynomial vanishes nowhere on a box, by one of some certificates. *)
Definition defined (rs : list range) (by_ : list cert) (p : pol) : bool :=
  existsb (fun c => check c rs true p || check c rs true (opp p))%bool (Direct :: by_).

Lemma defined_ok rs by_ l env :
  forallb (defined rs by_) l = true -> inbox rs env -> Forall (nz env) l.
Proof.
  intros H B. apply Forall_forall. intros p Hp. rewrite forallb_forall in H. specialize (H p Hp).
  unfold defined in H. apply existsb_exists in H as [c [_ H]]. unfold nz.
  apply orb_prop in H as [H | H]; apply (check_ok _ _ _ _ env) in H; auto; simpl in H; rewrite ?opp_ok in H; lra.
Qed.

Definition prove_zero (rs : list range) (by_ : list cert) (e : expr) : bool :=
  let r := norm e in (forallb (defined rs by_) (cs r) && is0 (num (fr r)))%bool.

Lemma zero_by rs by_ e env : prove_zero rs by_ e = true -> inbox rs env -> eval e env = 0.
Proof.
  unfold prove_zero. intros H B. apply andb_prop in H as [H Z]. apply (defined_ok _ _ _ env) in H; auto.
  destruct (norm_ok e env H) as [_ V]. rewrite <- V. unfold val. rewrite (is0_ok _ _ Z). unfold Rdiv. ring.
Qed.

(** Two formulas have the same value on a box. *)
Theorem equal_by rs by_ a b env :
  prove_zero rs by_ (Diff a b) = true -> inbox rs env -> eval a env = eval b env.
Proof. intros H B. pose proof (zero_by _ _ _ _ H B) as Z. simpl in Z. lra. Qed.

(** The integral of e from a to b is r. *)
Theorem integral_by rs by_ e a b r env :
  prove_zero rs by_ (Diff (Int e a b) r) = true -> inbox rs env ->
  is_RInt (fun x => eval e (x :: env)) (eval a env) (eval b env) (eval r env).
Proof.
  intros H B. rewrite <- (equal_by rs by_ (Int e a b) r env H B).
  unfold prove_zero in H. apply andb_prop in H as [H _]. apply (defined_ok _ _ _ env) in H; auto.
  simpl in H. apply joins_ok in H as [H _].
  destruct (fint (fr (norm e)) (fr (norm a)) (fr (norm b))) as [[f d]|] eqn:E; simpl in H.
  - apply join_ok in H as [N H]. apply joins_ok in H as [H I]. apply joins_ok in I as [I J].
    destruct (int_ok e _ _ _ _ _ _ env (norm_ok e) (norm_ok a env I) (norm_ok b env J) E N H) as [D _].
    simpl. rewrite (is_RInt_unique _ _ _ _ D). exact D.
  - exfalso. inversion H; subst. apply H2. simpl. apply Q2R_0.
Qed.

(** A formula has a derivative, and this is its value. *)
Theorem derivative_by rs by_ e a r env :
  prove_zero rs by_ (Diff (Der e a) r) = true -> inbox rs env ->
  is_derive (fun x => eval e (x :: env)) (eval a env) (eval r env).
Proof.
  intros H B. rewrite <- (equal_by rs by_ (Der e a) r env H B). simpl.
  unfold prove_zero in H. apply andb_prop in H as [H _]. apply (defined_ok _ _ _ env) in H; auto.
  simpl in H. apply joins_ok in H as [H _]. apply joins_ok in H as [H I].
  apply (at_first_ok _ _ _ _ (norm_ok a env I)) in H.
  apply Derive_correct. eexists. apply (der_ok e _ _ (norm_ok e) H).
Qed.

Definition prove_sign (s : bool) (rs : list range) (by_ : list cert) (cn cd : cert) (e : expr) : bool :=
  let r := norm e in
  (forallb (defined rs by_) (cs r) &&
   if check cd rs false (den (fr r)) then check cn rs s (num (fr r))
   else check cd rs false (opp (den (fr r))) && check cn rs s (opp (num (fr r))))%bool.

Theorem sign_by s rs by_ cn cd e env :
  prove_sign s rs by_ cn cd e = true -> inbox rs env -> sign s (eval e env).
Proof.
  unfold prove_sign. intros H B. apply andb_prop in H as [H K]. apply (defined_ok _ _ _ env) in H; auto.
  destruct (norm_ok e env H) as [D V]. rewrite <- V. unfold val, ok in *.
  assert (Q : forall n d, 0 <= d -> d <> 0 -> sign s n -> sign s (n / d)).
  { intros n d Hd Hn Hs. assert (0 < / d) by (apply Rinv_0_lt_compat; lra).
    destruct s; simpl in *; unfold Rdiv; [apply Rmult_lt_0_compat | apply Rmult_le_pos]; lra. }
  destruct (check cd rs false (den (fr (norm e)))) eqn:E.
  - apply Q; auto; [exact (check_ok _ _ _ _ env E B) | exact (check_ok _ _ _ _ env K B)].
  - apply andb_prop in K as [K1 K2]. apply (check_ok _ _ _ _ env) in K1, K2; auto.
    rewrite opp_ok in *. simpl in K1.
    replace (ev (num (fr (norm e))) env / ev (den (fr (norm e))) env)
      with (- ev (num (fr (norm e))) env / - ev (den (fr (norm e))) env) by (field; assumption).
    apply Q; auto; lra.
Qed.

Theorem le_by rs by_ cn cd a b env :
  prove_sign false rs by_ cn cd (Diff b a) = true -> inbox rs env -> eval a env <= eval b env.
Proof. intros H B. pose proof (sign_by _ _ _ _ _ _ _ H B) as Z. simpl in Z. lra. Qed.

Theorem lt_by rs by_ cn cd a b env :
  prove_sign true rs by_ cn cd (Diff b a) = true -> inbox rs env -> eval a env < eval b env.
Proof. intros H B. pose proof (sign_by _ _ _ _ _ _ _ H B) as Z. simpl in Z. lra. Qed.

(** The same of a quotient n/d that is given, for certificates which are about its parts and no others. *)
Definition prove_sign_over (s : bool) (rs : list range) (by_ : list cert) (cn cd : cert) (n d : pol) (e : expr) : bool :=
  let r := norm e in
  (forallb (defined rs by_) (cs r) && is0 (sub (mul (num (fr r)) d) (mul n (den (fr r)))) &&
   defined rs (cd :: by_) d && check cd rs false d && check cn rs s n)%bool.

Theorem sign_over s rs by_ cn cd n d e env :
  prove_sign_over s rs by_ cn cd n d e = true -> inbox rs env -> sign s (eval e env).
Proof.
  unfold prove_sign_over. intros H B. apply andb_prop in H as [H Hn]. apply andb_prop in H as [H Hd].
  apply andb_prop in H as [H Hz]. apply andb_prop in H as [H E].
  apply (defined_ok _ _ _ env) in H; auto. destruct (norm_ok e env H) as [D V]. rewrite <- V. unfold val, ok in *.
  assert (Z : ev d env <> 0).
  { assert (F : Forall (nz env) [d]) by (apply (defined_ok rs (cd :: by_)); [simpl; rewrite Hz; reflexivity | exact B]).
    inversion F; subst. assumption. }
  apply (check_ok _ _ _ _ env) in Hd, Hn; auto. simpl in Hd.
  apply (is0_ok _ env) in E. rewrite sub_ok, !mul_ok in E.
  replace (ev (num (fr (norm e))) env / ev (den (fr (norm e))) env) with (ev n env / ev d env).
  - assert (0 < / ev d env) by (apply Rinv_0_lt_compat; lra).
    destruct s; simpl in *; unfold Rdiv; [apply Rmult_lt_0_compat | apply Rmult_le_pos]; lra.
  - apply (Rmult_eq_reg_r (ev d env * ev (den (fr (norm e))) env)); [|apply Rmult_integral_contrapositive_currified; auto].
    field_simplify; auto. lra.
Qed.

Theorem le_over rs by_ cn cd n d a b env :
  prove_sign_over false rs by_ cn cd n d (Diff b a) = true -> inbox rs env -> eval a env <= eval b env.
Proof. intros H B. pose proof (sign_over _ _ _ _ _ _ _ _ _ H B) as Z. simpl in Z. lra. Qed.

Theorem lt_over rs by_ cn cd n d a b env :
  prove_sign_over true rs by_ cn cd n d (Diff b a) = true -> inbox rs env -> eval a env < eval b env.
Proof. intros H B. pose proof (sign_over _ _ _ _ _ _ _ _ _ H B) as Z. simpl in Z. lra. Qed.

(** A positive factor n/d by which one vector is a multiple of another one. *)
Lemma ratio_positive n d : 0 < n * d -> 0 < n / d.
Proof.
  intros H. assert (d <> 0) by (intros ->; lra).
  replace (n / d) with (n * d * (/ d * / d)) by (field; assumption).
  apply Rmult_lt_0_compat; auto. apply Rsqr_pos_lt, Rinv_neq_0_compat, H0.
Qed.

Lemma ratio_by n d a b : 0 < n * d -> d * a = n * b -> a = n / d * b.
Proof.
  intros H E. assert (d <> 0) by (intros ->; lra).
  apply (Rmult_eq_reg_l d); auto. rewrite E. field. assumption.
Qed.

(** A function as data, by the polynomials that vm_compute has made of its formula. *)
Theorem fn_by (f : list R -> R) e r :
  norm e = r -> (forall env, f env = eval e env) ->
  forall env, Forall (nz env) (cs r) -> is (fr r) env (f env).
Proof. intros <- E env H. rewrite E. apply norm_ok, H. Qed.

(** A function has a derivative. *)
Theorem ex_derive_by rs by_ e a env :
  forallb (defined rs by_) (cs (norm (Der e a))) = true -> inbox rs env ->
  ex_derive (fun x => eval e (x :: env)) (eval a env).
Proof.
  intros H B. apply (defined_ok _ _ _ env) in H; auto.
  simpl in H. apply joins_ok in H as [H I]. apply (at_first_ok _ _ _ _ (norm_ok a env I)) in H.
  eexists. apply (der_ok e _ _ (norm_ok e) H).
Qed.

(** * Angles *)

Lemma half_cos q : - PI < q < PI -> cos (q / 2) <> 0.
Proof. intros H. apply Rgt_not_eq, cos_gt_0; lra. Qed.

Lemma half_sum q : - PI < q < PI -> 1 + tan (q / 2) ^ 2 = / (cos (q / 2) * cos (q / 2)).
Proof.
  intros H. pose proof (half_cos q H) as C. unfold tan.
  pose proof (sin2_cos2 (q / 2)) as S. unfold Rsqr in S.
  replace (1 + (sin (q / 2) / cos (q / 2)) ^ 2)
    with ((sin (q / 2) * sin (q / 2) + cos (q / 2) * cos (q / 2)) / (cos (q / 2) * cos (q / 2))) by (field; auto).
  rewrite S. field; auto.
Qed.

(** With x = tan (q/2): sin and cos of an angle q between -π and π are quotients in tan (q/2). *)
Lemma sin_half p q : p = q -> - PI < q < PI -> sin p = 2 * tan (q / 2) / (1 + tan (q / 2) ^ 2).
Proof.
  intros -> H. pose proof (half_cos q H) as C. rewrite (half_sum q H).
  replace q with (2 * (q / 2)) at 1 by field. rewrite sin_2a. unfold tan. field. auto.
Qed.

Lemma cos_half p q : p = q -> - PI < q < PI -> cos p = (1 - tan (q / 2) ^ 2) / (1 + tan (q / 2) ^ 2).
Proof.
  intros -> H. pose proof (half_cos q H) as C. rewrite (half_sum q H).
  replace q with (2 * (q / 2)) at 1 by field. rewrite cos_2a. unfold tan. field. auto.
Qed.

(** Where the angle is a multiple of a quarter turn. *)
Lemma tan_at p (k : Z) : p = IZR k * (PI / 2) -> (-1 <= k <= 1)%Z -> tan (p / 2) = IZR k.
Proof.
  intros -> H. assert (E : (k = -1 \/ k = 0 \/ k = 1)%Z) by lia.
  destruct E as [-> | [-> | ->]].
  - replace (-1 * (PI / 2) / 2) with (- (PI / 4)) by field. rewrite tan_neg, tan_PI4. reflexivity.
  - replace (0 * (PI / 2) / 2) with 0 by field. apply tan_0.
  - replace (1 * (PI / 2) / 2) with (PI / 4) by field. apply tan_PI4.
Qed.

Lemma tan_le a b : - (PI / 2) < a -> a <= b -> b < PI / 2 -> tan a <= tan b.
Proof.
  intros A [H | ->] B; [left; apply tan_increasing; lra | right; reflexivity].
Qed.

(** The derivative of a function of an angle a·t + b, which is a function of the tangent of its half. *)
Lemma derive_angle f g a b t :
  (forall u, - PI < a * u + b < PI -> f u = g (tan ((a * u + b) / 2))) ->
  - PI < a * t + b < PI -> ex_derive g (tan ((a * t + b) / 2)) ->
  is_derive f t (Derive g (tan ((a * t + b) / 2)) * (a * ((1 + tan ((a * t + b) / 2) ^ 2) / 2))).
Proof.
  intros E H D.
  apply (is_derive_ext_loc (fun u => g (tan ((a * u + b) / 2)))).
  - assert (L : continuous (fun u : R => a * u + b) t).
    { apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
    assert (O : locally (a * t + b) (fun y : R => - PI < y < PI)).
    { apply (open_and (fun y => - PI < y) (fun y => y < PI)); [apply open_gt | apply open_lt | exact H]. }
    apply (filter_imp (fun u => - PI < a * u + b < PI)); [|exact (L _ O)].
    intros u Hu. symmetry. apply E, Hu.
  - pose proof (half_cos _ H) as C.
    assert (T : is_derive (fun u => tan ((a * u + b) / 2)) t (a * ((1 + tan ((a * t + b) / 2) ^ 2) / 2))).
    { pose proof (sin2_cos2 ((a * t + b) / 2)) as S. unfold Rsqr in S. unfold tan. auto_derive; [exact C|].
      change (a * t + b) with (a * t + b).
      replace ((a * t + b) * / 2) with ((a * t + b) / 2) by reflexivity.
      field_simplify; auto. }
    apply Derive_correct in D.
    pose proof (is_derive_comp g (fun u => tan ((a * u + b) / 2)) t _ _ D T) as G.
    evar_last; [exact G|]. unfold scal; simpl. unfold mult; simpl. ring.
Qed.

Lemma derive_angle_is f g a b t :
  (forall u, - PI < a * u + b < PI -> f u = g (tan ((a * u + b) / 2))) ->
  - PI < a * t + b < PI -> ex_derive g (tan ((a * t + b) / 2)) ->
  Derive f t = Derive g (tan ((a * t + b) / 2)) * (a * ((1 + tan ((a * t + b) / 2) ^ 2) / 2)).
Proof. intros E H D. apply is_derive_unique, derive_angle; assumption. Qed.

(** Twice the angle. *)
Lemma sin_twice p q : p = 2 * q -> - PI < q < PI ->
  sin p = 2 * (2 * tan (q / 2) / (1 + tan (q / 2) ^ 2)) * ((1 - tan (q / 2) ^ 2) / (1 + tan (q / 2) ^ 2)).
Proof. intros -> H. rewrite sin_2a, (sin_half q q), (cos_half q q); auto. Qed.

Lemma cos_twice p q : p = 2 * q -> - PI < q < PI ->
  cos p = ((1 - tan (q / 2) ^ 2) / (1 + tan (q / 2) ^ 2)) ^ 2 - (2 * tan (q / 2) / (1 + tan (q / 2) ^ 2)) ^ 2.
Proof. intros -> H. rewrite cos_2a, (sin_half q q), (cos_half q q); auto. ring. Qed.

(** Bounds of an angle, and of the tangent of its half. *)
Lemma tan_lt a b : - (PI / 2) < a -> a < b -> b < PI / 2 -> tan a < tan b.
Proof. intros. apply tan_increasing; lra. Qed.

Lemma tangent_from k q : (-1 <= k <= 1)%Z -> IZR k * (PI / 2) <= q -> q < PI -> IZR k <= tan (q / 2).
Proof.
  intros K L H. pose proof PI_RGT_0. assert (-1 <= IZR k) by (apply IZR_le; lia).
  rewrite <- (tan_at _ k eq_refl K). apply tan_le; nra.
Qed.

Lemma tangent_above k q : (-1 <= k <= 1)%Z -> IZR k * (PI / 2) < q -> q < PI -> IZR k < tan (q / 2).
Proof.
  intros K L H. pose proof PI_RGT_0. assert (-1 <= IZR k) by (apply IZR_le; lia).
  rewrite <- (tan_at _ k eq_refl K). apply tan_lt; nra.
Qed.

Lemma tangent_to k q : (-1 <= k <= 1)%Z -> q <= IZR k * (PI / 2) -> - PI < q -> tan (q / 2) <= IZR k.
Proof.
  intros K L H. pose proof PI_RGT_0. assert (IZR k <= 1) by (apply IZR_le; lia).
  rewrite <- (tan_at _ k eq_refl K). apply tan_le; nra.
Qed.

Lemma tangent_below k q : (-1 <= k <= 1)%Z -> q < IZR k * (PI / 2) -> - PI < q -> tan (q / 2) < IZR k.
Proof.
  intros K L H. pose proof PI_RGT_0. assert (IZR k <= 1) by (apply IZR_le; lia).
  rewrite <- (tan_at _ k eq_refl K). apply tan_lt; nra.
Qed.

(** The angle that is reflected: its tangent is that of a difference. *)
Lemma tan_mirror p q (k : Z) : p = IZR k * (PI / 2) - q -> (-1 <= k <= 1)%Z -> - PI < q < PI -> - PI < p < PI ->
  tan (p / 2) = (IZR k - tan (q / 2)) / (1 + IZR k * tan (q / 2)).
Proof.
  intros E K Q P. pose proof (half_cos q Q) as C. pose proof (half_cos p P) as D.
  pose proof PI_RGT_0.
  assert (B : cos (IZR k * (PI / 2) / 2) <> 0).
  { apply half_cos. assert (-1 <= IZR k <= 1) by (split; apply IZR_le; lia). nra. }
  replace (p / 2) with (IZR k * (PI / 2) / 2 - q / 2) in * by (rewrite E; field).
  assert (N : 1 + tan (IZR k * (PI / 2) / 2) * tan (q / 2) <> 0).
  { rewrite cos_minus in D. intros N. apply D. unfold tan in N.
    replace (cos (IZR k * (PI / 2) / 2) * cos (q / 2) + sin (IZR k * (PI / 2) / 2) * sin (q / 2))
      with (cos (IZR k * (PI / 2) / 2) * cos (q / 2) *
        (1 + sin (IZR k * (PI / 2) / 2) / cos (IZR k * (PI / 2) / 2) * (sin (q / 2) / cos (q / 2)))) by (field; auto).
    rewrite N. ring. }
  rewrite tan_minus by assumption. rewrite (tan_at _ k eq_refl K). reflexivity.
Qed.

(** An angle a t + b whose half has a given tangent. *)
Lemma angle_of a b x : 0 < a -> exists t, - PI < a * t + b < PI /\ tan ((a * t + b) / 2) = x.
Proof.
  intros A. exists ((2 * atan x - b) / a). apply Rgt_not_eq in A.
  replace (a * ((2 * atan x - b) / a) + b) with (2 * atan x) by (field; assumption).
  replace (2 * atan x / 2) with (atan x) by field. pose proof (atan_bound x).
  split; [lra | apply atan_right_inv].
Qed.

(** Bounds of a tangent, and of the angle. *)
Lemma angle_from k q x : (-1 <= k <= 1)%Z -> - PI < q < PI -> tan (q / 2) = x -> IZR k <= x -> IZR k * (PI / 2) <= q.
Proof.
  intros K Q <- L. apply Rnot_lt_le. intros N. pose proof (tangent_below k q K N (proj1 Q)). lra.
Qed.

Lemma angle_above k q x : (-1 <= k <= 1)%Z -> - PI < q < PI -> tan (q / 2) = x -> IZR k < x -> IZR k * (PI / 2) < q.
Proof.
  intros K Q <- L. apply Rnot_le_lt. intros N. pose proof (tangent_to k q K N (proj1 Q)). lra.
Qed.

Lemma angle_to k q x : (-1 <= k <= 1)%Z -> - PI < q < PI -> tan (q / 2) = x -> x <= IZR k -> q <= IZR k * (PI / 2).
Proof.
  intros K Q <- L. apply Rnot_lt_le. intros N. pose proof (tangent_above k q K N (proj2 Q)). lra.
Qed.

Lemma angle_below k q x : (-1 <= k <= 1)%Z -> - PI < q < PI -> tan (q / 2) = x -> x < IZR k -> q < IZR k * (PI / 2).
Proof.
  intros K Q <- L. apply Rnot_le_lt. intros N. pose proof (tangent_from k q K N (proj2 Q)). lra.
Qed.

Ltac angle := pose proof PI_RGT_0; split; nra.
Ltac tangent by_ := apply by_; [lia | |]; pose proof PI_RGT_0; nra.
(** An angle is in its range, of whose ends the multiples of a quarter turn are known. *)
Ltac arrive := pose proof PI_RGT_0; repeat split; nra.

(** * Linear independence *)

(** ** Polynomials that vanish on an interval *)

(** The quotient of c0 + c1 x + ... by x - r. *)
Fixpoint divided (r : R) (l : list R) : list R :=
  match l with
  | [] => []
  | _ :: l => match l with [] => [] | _ => horner r l :: divided r l end
  end.

Lemma divided_ok r x l : horner x l = horner r l + (x - r) * horner x (divided r l).
Proof.
  induction l as [|c l IH]; simpl; [ring|]. destruct l as [|d l]; [simpl; ring|].
  change (horner x (horner r (d :: l) :: divided r (d :: l)))
    with (horner r (d :: l) + x * horner x (divided r (d :: l))).
  rewrite IH. ring.
Qed.

Lemma divided_length r l : length (divided r l) = pred (length l).
Proof. induction l as [|c [|d l] IH]; auto. simpl in *. rewrite IH. reflexivity. Qed.

Lemma divided_zero r l : (forall n, nth n (divided r l) 0 = 0) -> horner r l = 0 -> forall n, nth n l 0 = 0.
Proof.
  induction l as [|c l IH]; intros D H n; [destruct n; reflexivity|].
  destruct l as [|d l].
  - simpl in H. destruct n as [|[|n]]; simpl; lra.
  - assert (E : horner r (d :: l) = 0) by exact (D O).
    assert (G : forall n, nth n (d :: l) 0 = 0) by (apply IH; [intros m; exact (D (S m)) | exact E]).
    destruct n; [|exact (G n)]. change (c + r * horner r (d :: l) = 0) in H. rewrite E in H. simpl. lra.
Qed.

Lemma vanishes : forall k l lo hi, (length l <= k)%nat -> lo < hi ->
  (forall x, lo < x < hi -> horner x l = 0) -> forall n, nth n l 0 = 0.
Proof.
  induction k as [|k IH]; intros l lo hi L H Z n.
  - destruct l; [destruct n; reflexivity | simpl in L; lia].
  - set (r := (lo + hi) / 2). assert (Hr : lo < r < hi) by (unfold r; lra).
    apply (divided_zero r); [|apply Z, Hr].
    apply (IH _ r hi); [rewrite divided_length; lia | lra |].
    intros x Hx. pose proof (divided_ok r x l) as D. rewrite (Z x), (Z r) in D by lra.
    apply (Rmult_eq_reg_l (x - r)); lra.
Qed.

(** ** Combinations *)

(** A k p0 + A (k + 1) p1 + ... *)
Fixpoint sumf (A : nat -> R) (k : nat) (ps : list pol) (env : list R) : R :=
  match ps with [] => 0 | p :: ps => A k * ev p env + sumf A (S k) ps env end.

Fixpoint radd (l m : list R) : list R :=
  match l, m with [], _ => m | _, [] => l | a :: l, b :: m => a + b :: radd l m end.

Lemma radd_horner l m x : horner x (radd l m) = horner x l + horner x m.
Proof. revert m. induction l as [|a l IH]; intros [|b m]; simpl; rewrite ?IH; ring. Qed.

Lemma radd_nth l m n : nth n (radd l m) 0 = nth n l 0 + nth n m 0.
Proof.
  revert m n. induction l as [|a l IH]; intros [|b m] [|n]; simpl; rewrite ?IH; try ring; destruct n; ring.
Qed.

Fixpoint lsum (A : nat -> R) (k : nat) (ps : list pol) (e : list R) : list R :=
  match ps with
  | [] => []
  | p :: ps => radd (map (fun c => A k * ev c e) (coefs p)) (lsum A (S k) ps e)
  end.

Lemma lsum_horner A ps x e : forall k, horner x (lsum A k ps e) = sumf A k ps (x :: e).
Proof.
  induction ps as [|p ps IH]; intros k; simpl; [reflexivity|]. rewrite radd_horner, IH.
  rewrite (coefs_ok p). simpl. f_equal. induction (coefs p) as [|c l IHl]; simpl; [ring|]. rewrite IHl. ring.
Qed.

Lemma lsum_nth A n ps e : forall k,
  nth n (lsum A k ps e) 0 = sumf A k (map (fun p => nth n (coefs p) (C 0)) ps) e.
Proof.
  induction ps as [|p ps IH]; intros k; simpl; [destruct n; reflexivity|]. rewrite radd_nth, IH. f_equal.
  replace 0 with (A k * ev (C 0) e) by (simpl; rewrite Q2R_0; ring).
  rewrite (map_nth (fun c => A k * ev c e)). reflexivity.
Qed.

(** Every number is strictly between two others. *)
Fixpoint inside (dims : list (Q * Q)) (xs : list R) : Prop :=
  match dims, xs with
  | [], [] => True
  | d :: dims, x :: xs => (Q2R (fst d) < x < Q2R (snd d)) /\ inside dims xs
  | _, _ => False
  end.

(** The coefficient of a monomial in the first variables. *)
Fixpoint coef (m : list nat) (p : pol) : pol :=
  match m with [] => p | n :: m => coef m (nth n (coefs p) (C 0)) end.

Lemma coefficients A dims e : Forall (fun d => Q2R (fst d) < Q2R (snd d)) dims -> forall ps,
  (forall xs, inside dims xs -> sumf A 0 ps (xs ++ e) = 0) ->
  forall m, length m = length dims -> sumf A 0 (map (coef m) ps) e = 0.
Proof.
  intros D. induction D as [|d dims Hd D IH]; intros ps H [|n m] L; try discriminate L.
  - simpl. rewrite map_id. exact (H [] I).
  - simpl in L. injection L as L.
    replace (map (coef (n :: m)) ps) with (map (coef m) (map (fun p => nth n (coefs p) (C 0)) ps))
      by (rewrite map_map; reflexivity).
    apply IH; [|exact L]. intros xs Hxs. rewrite <- lsum_nth.
    apply (vanishes _ _ (Q2R (fst d)) (Q2R (snd d)) (le_n _) Hd).
    intros x Hx. rewrite lsum_horner. exact (H (x :: xs) (conj Hx Hxs)).
Qed.

(** ** Elimination *)

(** A sum of coefficients with factors, in which of all rows but those with a known factor 0 one only is left: the number
    of that row, the sum, and why what is left is not zero. *)
Record step := Step { row : nat; sum : list (list nat * pol); by_sign : cert }.

Definition take (s : list (list nat * pol)) (p : pol) : pol :=
  fold_right (fun mn acc => add (mul (snd mn) (coef (fst mn) p)) acc) (C 0) s.

Fixpoint others (k i : nat) (known : list nat) (vals : list pol) : bool :=
  match vals with
  | [] => true
  | p :: vals => ((existsb (Nat.eqb k) known || Nat.eqb k i || is0 p) && others (S k) i known vals)%bool
  end.

Fixpoint eliminate (dims : nat) (rs : list range) (ps : list pol) (steps : list step) (known : list nat) : bool :=
  match steps with
  | [] => forallb (fun k => existsb (Nat.eqb k) known) (seq 0 (length ps))
  | s :: steps =>
    let vals := map (take (sum s)) ps in
    let d := nth (row s) vals (C 0) in
    (forallb (fun mn => Nat.eqb (length (fst mn)) dims) (sum s) && Nat.ltb (row s) (length ps) &&
     others 0 (row s) known vals && (check (by_sign s) rs true d || check (by_sign s) rs true (opp d)) &&
     eliminate dims rs ps steps (row s :: known))%bool
  end.

Lemma known_zero (A : nat -> R) known k :
  (forall m, In m known -> A m = 0) -> existsb (Nat.eqb k) known = true -> A k = 0.
Proof.
  intros H E. apply existsb_exists in E as [m [I E]]. apply Nat.eqb_eq in E. subst. auto.
Qed.

Lemma others_beyond A i known env vals : (forall m, In m known -> A m = 0) ->
  forall k, (i < k)%nat -> others k i known vals = true -> sumf A k vals env = 0.
Proof.
  intros K. induction vals as [|p vals IH]; intros k L H; simpl in *; [reflexivity|].
  apply andb_prop in H as [H G]. rewrite (IH (S k)); [|lia | exact G].
  apply orb_prop in H as [H | H]; [apply orb_prop in H as [H | H]|].
  - rewrite (known_zero A known k K H). ring.
  - apply Nat.eqb_eq in H. lia.
  - rewrite (is0_ok p env H). ring.
Qed.

Lemma others_ok A i known env vals : (forall m, In m known -> A m = 0) ->
  forall k, (k <= i)%nat -> others k i known vals = true ->
  sumf A k vals env = A i * ev (nth (i - k) vals (C 0)) env.
Proof.
  intros K. induction vals as [|p vals IH]; intros k L H; simpl in *.
  - destruct (i - k)%nat; simpl; rewrite Q2R_0; ring.
  - apply andb_prop in H as [H G]. destruct (Nat.eq_dec k i) as [E | E].
    + subst. rewrite (others_beyond A i known env vals K (S i)) by (auto; lia).
      replace (i - i)%nat with O by lia. ring.
    + rewrite (IH (S k)) by (auto; lia). replace (i - k)%nat with (S (i - S k)) by lia.
      assert (Z : A k * ev p env = 0).
      { apply orb_prop in H as [H | H]; [apply orb_prop in H as [H | H]|].
        - rewrite (known_zero A known k K H). ring.
        - apply Nat.eqb_eq in H. contradiction.
        - rewrite (is0_ok p env H). ring. }
      simpl. lra.
Qed.

Lemma sumf_map_add A (f g : pol -> pol) ps env : forall k,
  sumf A k (map (fun p => add (f p) (g p)) ps) env = sumf A k (map f ps) env + sumf A k (map g ps) env.
Proof. induction ps; intros k; simpl; [ring|]. rewrite add_ok, IHps. ring. Qed.

Lemma sumf_map_mul A q (f : pol -> pol) ps env : forall k,
  sumf A k (map (fun p => mul q (f p)) ps) env = ev q env * sumf A k (map f ps) env.
Proof. induction ps; intros k; simpl; [ring|]. rewrite mul_ok, IHps. ring. Qed.

Lemma sumf_zero A (ps : list pol) env : forall k, sumf A k (map (fun _ => C 0) ps) env = 0.
Proof. induction ps; intros k; simpl; [reflexivity|]. rewrite IHps, Q2R_0. ring. Qed.

Lemma take_zero A ps env s :
  Forall (fun mn => sumf A 0 (map (coef (fst mn)) ps) env = 0) s -> sumf A 0 (map (take s) ps) env = 0.
Proof.
  intros H. induction H as [|mn s Hmn H IH].
  - apply sumf_zero.
  - change (map (take (mn :: s)) ps) with (map (fun p => add (mul (snd mn) (coef (fst mn) p)) (take s p)) ps).
    rewrite sumf_map_add, IH, (sumf_map_mul A (snd mn) (coef (fst mn))), Hmn. ring.
Qed.

Lemma eliminate_ok A dims rs ps env :
  (forall m, length m = dims -> sumf A 0 (map (coef m) ps) env = 0) -> inbox rs env ->
  forall steps known, (forall m, In m known -> A m = 0) -> eliminate dims rs ps steps known = true ->
  forall k, (k < length ps)%nat -> A k = 0.
Proof.
  intros Z B. induction steps as [|s steps IH]; intros known K H k L; simpl in H.
  - rewrite forallb_forall in H. apply (known_zero A known k K). apply H. apply in_seq. lia.
  - apply andb_prop in H as [H H5]. apply andb_prop in H as [H H4]. apply andb_prop in H as [H H3].
    apply andb_prop in H as [H1 H2]. apply Nat.ltb_lt in H2.
    apply (IH (row s :: known)); auto. intros m [<- | M]; auto.
    assert (S : sumf A 0 (map (take (sum s)) ps) env = 0).
    { apply take_zero. apply Forall_forall. intros mn Hmn. apply Z. rewrite forallb_forall in H1.
      apply Nat.eqb_eq. apply H1, Hmn. }
    rewrite (others_ok A (row s) known env _ K 0 (Nat.le_0_l _) H3) in S. rewrite Nat.sub_0_r in S.
    set (d := nth (row s) (map (take (sum s)) ps) (C 0)) in *.
    assert (N : ev d env <> 0).
    { apply orb_prop in H4 as [G | G]; apply (check_ok _ _ _ _ env) in G; auto; simpl in G;
        rewrite ?opp_ok in G; lra. }
    apply (Rmult_eq_reg_r (ev d env)); [lra | exact N].
Qed.

(** ** Functions *)

Fixpoint sume (A : nat -> R) (k : nat) (es : list expr) (env : list R) : R :=
  match es with [] => 0 | e :: es => A k * eval e env + sume A (S k) es env end.

(** Whether formulas are the quotients p/d of given polynomials p and one d. *)
Fixpoint over (d : pol) (ps : list pol) (ns : list norm_result) : bool :=
  match ps, ns with
  | [], [] => true
  | p :: ps, n :: ns => (is0 (sub (mul (num (fr n)) d) (mul p (den (fr n)))) && over d ps ns)%bool
  | _, _ => false
  end.

Lemma over_ok A d es env : forall ps k,
  over d ps (map norm es) = true -> Forall (fun e => Forall (nz env) (cs (norm e))) es ->
  sumf A k ps env = ev d env * sume A k es env.
Proof.
  induction es as [|e es IH]; intros [|p ps] k H F; simpl in *; try discriminate; [ring|].
  apply andb_prop in H as [H1 H2]. inversion F; subst. rewrite (IH ps (S k)) by assumption.
  apply (is0_ok _ env) in H1. rewrite sub_ok, !mul_ok in H1.
  destruct (norm_ok e env H3) as [D V]. rewrite <- V. unfold val, ok in *.
  replace (ev p env) with (ev (num (fr (norm e))) env * ev d env / ev (den (fr (norm e))) env); [field; exact D|].
  apply (Rmult_eq_reg_r (ev (den (fr (norm e))) env)); [|exact D]. field_simplify; [lra | exact D].
Qed.

Lemma over_length d es : forall ps, over d ps (map norm es) = true -> length ps = length es.
Proof.
  induction es as [|e es IH]; intros [|p ps] H; simpl in *; try discriminate; [reflexivity|].
  apply andb_prop in H as [_ H]. f_equal. apply IH, H.
Qed.

Definition wide (dims : list (Q * Q)) : list range := map (fun d => (Excl (fst d), Excl (snd d))) dims.

Definition prove_independent (rs : list range) (by_ : list cert) (dims : list (Q * Q)) (es : list expr)
  (d : pol) (ps : list pol) (steps : list step) : bool :=
  let ns := map norm es in
  (forallb (fun d => qlt (fst d) (snd d)) dims &&
   forallb (fun r => forallb (defined (wide dims ++ rs) by_) (cs r)) ns &&
   over d ps ns && eliminate (length dims) rs ps steps [])%bool.

Lemma inside_box dims rs xs env : inside dims xs -> inbox rs env -> inbox (wide dims ++ rs) (xs ++ env).
Proof.
  revert xs. induction dims as [|d dims IH]; intros [|x xs] H B; simpl in *; try contradiction; auto.
  destruct H as [H G]. auto.
Qed.

Lemma forallb_mapped {T U} (f : U -> bool) (g : T -> U) l : forallb f (map g l) = forallb (fun x => f (g x)) l.
Proof. induction l; simpl; [reflexivity|]. rewrite IHl. reflexivity. Qed.

(** If a combination of functions is zero inside of a box in the first variables, all of its factors are zero. The
    functions are p/d for given polynomials p and one d. *)
Theorem independent_by rs by_ dims es d ps steps env A :
  prove_independent rs by_ dims es d ps steps = true -> inbox rs env ->
  (forall xs, inside dims xs -> sume A 0 es (xs ++ env) = 0) ->
  forall k, (k < length es)%nat -> A k = 0.
Proof.
  unfold prove_independent. intros H B Z.
  apply andb_prop in H as [H E]. apply andb_prop in H as [H H3]. apply andb_prop in H as [H1 H2].
  rewrite <- (over_length d es ps H3).
  refine (eliminate_ok A (length dims) rs ps env _ B steps [] _ E); [|intros m []].
  apply coefficients.
  - apply Forall_forall. intros c Hc. rewrite forallb_forall in H1. apply qlt_ok, H1, Hc.
  - intros xs Hxs. rewrite (over_ok A d es _ ps 0 H3); [rewrite (Z xs Hxs); ring|].
    apply Forall_forall. intros e He. rewrite forallb_mapped, forallb_forall in H2.
    exact (defined_ok _ _ _ _ (H2 e He) (inside_box _ _ _ _ Hxs B)).
Qed.

(** ** For the texts of proofs *)

(** What is left of a part of c in front of it: barycentric coordinates as images of a box. *)
Lemma split_off (c x : R) : 0 <= x -> x <= c -> exists s, 0 <= s <= 1 /\ x = c * (1 - s).
Proof.
  intros H0 H1. destruct (Req_dec c 0) as [E | E].
  - exists 0. split; [lra|]. replace x with 0 by lra. rewrite E. ring.
  - exists (1 - x / c). assert (0 < c) by lra. split.
    + split.
      * apply Rmult_le_reg_r with c; [assumption|]. unfold Rdiv.
        rewrite Rmult_minus_distr_r, Rmult_assoc, Rinv_l; lra.
      * assert (0 <= x / c) by (unfold Rdiv; apply Rmult_le_pos; [assumption | apply Rlt_le, Rinv_0_lt_compat; assumption]).
        lra.
    + field. assumption.
Qed.

(** All variables are in their ranges. *)
Ltac box := cbv [inbox above below fst snd hd tl Q2R Qnum Qden]; repeat split; lra.
(** One of several boxes. *)
Ltac apart := first [lra | repeat split; lra | left; apart | right; apart].
(** A program says that it is so. *)
Ltac run := vm_cast_no_check (eq_refl true).
