package org.starl.lang.prove;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Type;

/** The value of an expression: text of SMT-LIB, or what is made of such texts. */
sealed interface Val {

  /** A value that SMT-LIB has as a term. */
  record Term(String smt) implements Val {}

  /**
   * A map, or a set as a map to {@code bool}: its value at arguments.
   *
   * @param array the term, if it is an array
   */
  record Fn(Type.MapOf type, Function<List<String>, Val> at, @Nullable String array)
      implements Val {}

  /** The state of an automaton: its components. */
  record Cells(Map<String, Val> cells) implements Val {}

  /** The text of a value that is no map. */
  static String smt(Val value) {
    return ((Term) value).smt();
  }
}
