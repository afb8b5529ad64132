package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.lang.tree.Type.Field;

/**
 * An action.
 *
 * @param pre the conjuncts of its enabling condition; none if it is always enabled
 * @param eff what it changes, at once: each right side reads the state before
 * @param fairness empty if it need not be taken, however long it may be
 * @param comment the lines of comment before it
 * @param note the comment at the end of its first line; empty if there is none
 */
public record Action(
    String name,
    List<Field> parameters,
    List<Conjunct> pre,
    List<Effect> eff,
    Optional<Fairness> fairness,
    List<String> comment,
    String note,
    Pos pos) {

  /** Not fair, and without comments. */
  public Action(
      String name, List<Field> parameters, List<Conjunct> pre, List<Effect> eff, Pos pos) {
    this(name, parameters, pre, eff, Optional.empty(), List.of(), "", pos);
  }

  /**
   * A conjunct of an enabling condition.
   *
   * @param text as in the source, on one line
   */
  public record Conjunct(Expr condition, String text) {}

  /**
   * That steps are taken which stay possible; with {@code isStrong}, also those that are possible again
   * and again.
   *
   * @param group actions of one group and of equal values count as one
   * @param each the numbers of the parameters for each of whose values this is so
   */
  public record Fairness(boolean isStrong, String group, List<Integer> each) {}

  /** A change of the state. */
  public sealed interface Effect {

    /** Where its text begins. */
    Pos pos();

    /** The expressions in it. */
    default List<Expr> parts() {
      List<Expr> parts = new ArrayList<>();
      switch (this) {
        case Assign assign -> {
          for (Selector selector : assign.selectors()) {
            if (selector instanceof Selector.At at) {
              parts.addAll(at.arguments());
            }
          }
          parts.add(assign.value());
        }
        case Step step -> {
          step.condition().ifPresent(parts::add);
          parts.addAll(step.arguments());
        }
      }
      return parts;
    }

    /** {@code Leader(i).who := none}. */
    record Assign(String component, List<Selector> selectors, Expr value, Pos pos)
        implements Effect {}

    /**
     * {@code if c then mux.release(i, RS)}: a step of the used automaton.
     *
     * @param condition without it there is no step; empty if there always is one
     */
    record Step(
        Optional<Expr> condition,
        String used,
        Automaton automaton,
        Action action,
        List<Expr> arguments,
        Pos pos)
        implements Effect {}
  }

  /** A part of a component. */
  public sealed interface Selector {

    /** The value of a map at these arguments. */
    record At(List<Expr> arguments) implements Selector {}

    /** A field of a record. */
    record Of(String field) implements Selector {}
  }
}
