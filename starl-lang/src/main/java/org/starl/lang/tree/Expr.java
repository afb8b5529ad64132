package org.starl.lang.tree;

import java.math.BigDecimal;
import java.util.List;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/** An expression whose names are resolved and whose types are checked. */
public sealed interface Expr {

  /** Its type. */
  Type type();

  /** Where its text begins. */
  Pos pos();

  /** {@code true} or {@code false}. */
  record Bool(boolean value, Pos pos) implements Expr {
    @Override
    public Type type() {
      return Type.Bool.BOOL;
    }
  }

  /** A number that is not negative. */
  record Numeral(BigDecimal value, Type type, Pos pos) implements Expr {}

  /** A parameter of an action or function, or a variable of a quantifier, comprehension or case. */
  record Variable(String name, Type type, Pos pos) implements Expr {}

  /** A value parameter of the automaton. */
  record Parameter(String name, Type type, Pos pos) implements Expr {}

  /** A component of the present state. */
  record Component(String name, Type type, Pos pos) implements Expr {}

  /** {@code f(a, b)} of a map. */
  record At(Expr map, List<Expr> arguments, Type type, Pos pos) implements Expr {}

  /**
   * A call of a function of the automaton, or of a used one.
   *
   * @param used the component of the used automaton; empty for the automaton's own
   */
  record Call(String used, Signature function, List<Expr> arguments, Pos pos) implements Expr {
    @Override
    public Type type() {
      return function.result();
    }
  }

  /** {@code mux.release(i, RS)}: whether the action of the used automaton is enabled. */
  record Enabled(String used, Automaton automaton, Action action, List<Expr> arguments, Pos pos)
      implements Expr {
    @Override
    public Type type() {
      return Type.Bool.BOOL;
    }
  }

  /** {@code mux.start?}: whether the used automaton is in a start state. */
  record Started(String used, Automaton automaton, Pos pos) implements Expr {
    @Override
    public Type type() {
      return Type.Bool.BOOL;
    }
  }

  /** {@code r.field} of a record, of the state of a used automaton, or of a constructor's value. */
  record Get(Expr of, String field, Type type, Pos pos) implements Expr {}

  /** A value of a sum. */
  record Make(Constructor constructor, List<Expr> arguments, Type type, Pos pos) implements Expr {}

  /** A value of a record: {@code values} are in the order of its fields. */
  record MakeRecord(List<Expr> values, Type type, Pos pos) implements Expr {}

  /** {@code x is failed}. */
  record Is(Expr of, Constructor constructor, Pos pos) implements Expr {
    @Override
    public Type type() {
      return Type.Bool.BOOL;
    }
  }

  /** {@code match x { open -> a, failed(M) -> b }}, a case for each constructor. */
  record Match(Expr of, List<Case> cases, Type type, Pos pos) implements Expr {}

  /** A case of a {@link Match}. */
  record Case(Constructor constructor, List<Field> variables, Expr value) {}

  /** {@code not a}. */
  record Not(Expr of, Pos pos) implements Expr {
    @Override
    public Type type() {
      return Type.Bool.BOOL;
    }
  }

  /** {@code -a}. */
  record Negative(Expr of, Pos pos) implements Expr {
    @Override
    public Type type() {
      return Type.isNumber(of.type(), Type.Num::isWhole) ? Type.Num.INT : Type.Num.REAL;
    }
  }

  /** {@code a + b}, {@code a union b}, {@code a and b} and so on. */
  record Binary(Operator operator, Expr left, Expr right, Type type, Pos pos) implements Expr {}

  /** {@code forall i: PIDS :: a}, {@code exists i: PIDS :: a}. */
  record Quantified(boolean forAll, List<Field> variables, Expr body, Pos pos) implements Expr {
    @Override
    public Type type() {
      return Type.Bool.BOOL;
    }
  }

  /** {@code if a then b else c}. */
  record If(Expr condition, Expr then, Expr otherwise, Type type, Pos pos) implements Expr {}

  /** {@code {i: PIDS | a}}. */
  record SuchThat(Field variable, Expr body, Type type, Pos pos) implements Expr {}

  /** {@code {a, b}}. */
  record SetOf(List<Expr> elements, Type type, Pos pos) implements Expr {}

  /** {@code [i: PIDS -> a]}. */
  record MapOf(List<Field> variables, Expr body, Type type, Pos pos) implements Expr {}

  /** {@code [a, b]}. */
  record ListOf(List<Expr> elements, Type type, Pos pos) implements Expr {}

  /** {@code none}. */
  record None(Type type, Pos pos) implements Expr {}

  /** {@code some(a)}. */
  record Some(Expr of, Type type, Pos pos) implements Expr {}

  /**
   * A function of the language: {@code the}, {@code head}, {@code tail}, {@code length}, {@code
   * card}, {@code elements}, {@code distinct}; and what has no name there.
   */
  record BuiltIn(Name name, Expr of, Type type, Pos pos) implements Expr {

    /** Which one. */
    public enum Name {
      /** The value of an option that is not {@code none}. */
      THE,
      /** The first element of a list that is not empty. */
      HEAD,
      /** A list that is not empty, without its first element. */
      TAIL,
      /** The number of a list's elements. */
      LENGTH,
      /** The number of elements of a finite set. */
      CARD,
      /** The set of a list's elements. */
      ELEMENTS,
      /** Whether no element of a list is in it twice. */
      DISTINCT,
      /** An element of a set that is not empty: of equal sets the same one. */
      CHOOSE,
      /** A number as a value of a {@link Type.Range} in which it is. */
      WITHIN
    }
  }

  /** Operators of two operands, by their text. */
  enum Operator {
    AND("and"),
    OR("or"),
    IMPLIES("=>"),
    IFF("<=>"),
    EQUAL("="),
    UNEQUAL("!="),
    LESS("<"),
    AT_MOST("<="),
    GREATER(">"),
    AT_LEAST(">="),
    IN("in"),
    SUBSET("subset"),
    DISJOINT("disjoint"),
    UNION("union"),
    MINUS("minus"),
    INTERSECT("intersect"),
    /** Of lists. */
    JOIN("++"),
    /** {@code l(n)}: the element of a list that has {@code n} before it. */
    NTH("()"),
    PLUS("+"),
    LESS_BY("-"),
    TIMES("*"),
    DIVIDED_BY("/"),
    MOD("mod");

    private final String text;

    Operator(String text) {
      this.text = text;
    }

    /** As in a source. */
    public String text() {
      return text;
    }
  }
}
