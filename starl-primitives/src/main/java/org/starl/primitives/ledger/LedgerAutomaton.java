// Generated from Ledger_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.ledger;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Term;

/**
 * The automaton Ledger_decls, executable.
 *
 * <p>A ledger of tasks: each is added, claimed, begun and finished, by robots that crash and
 * restart.
 *
 * <p>One log has all changes, in order; `stage' and `claims' are what it says. A claim has a
 * number. The begin of a task is the point of no return: before it a claim may be ended by anybody,
 * after it only by the application (reopen). A robot that is told that it has begun may do the
 * task; it may be told long after, when the log has gone on.
 *
 * <p>Nothing is assumed: `free' may come at any time, so no clock matters. A restart ends the
 * robot's claims that are not begun, and the robot forgets what it was told. Java:
 * org.starl.primitives.ledger.TaskLedger; this automaton: LedgerAutomaton; monitors: LedgerSpec,
 * LedgerConformance.
 */
public final class LedgerAutomaton implements Automaton<LedgerAutomaton.States, LedgerAction> {

  /** The theory's name. */
  public static final String LEDGER_DECLS = "Ledger_decls";

  public sealed interface Stage extends Term, Comparable<Stage> {

    record absent() implements Stage {
      @Override
      public String toString() {
        return text();
      }
    }

    // The theory's name; in module declarations it is a keyword.
    @SuppressWarnings("NamedLikeContextualKeyword")
    record open() implements Stage {
      @Override
      public String toString() {
        return text();
      }
    }

    record claimed(RobotId who) implements Stage {
      @Override
      public String toString() {
        return text();
      }
    }

    record begun(RobotId who) implements Stage {
      @Override
      public String toString() {
        return text();
      }
    }

    record finished() implements Stage {
      @Override
      public String toString() {
        return text();
      }
    }

    @Override
    default List<Object> args() {
      return switch (this) {
        case absent a -> List.of();
        case open a -> List.of();
        case claimed a -> List.of(a.who);
        case begun a -> List.of(a.who);
        case finished a -> List.of();
      };
    }

    @Override
    default int compareTo(Stage that) {
      return Sets.compare(this, that);
    }
  }

  /**
   * The states.
   *
   * @param claims the number of the latest claim
   * @param beginner the robot that began it under a claim
   * @param reopened whether that was undone
   * @param told the claim under which a robot was told to do it; 0: none
   */
  public record States(
      Fun<TaskId, Stage> stage,
      Fun<TaskId, Long> claims,
      Fun<TaskId, Fun<Long, Lift<RobotId>>> beginner,
      Fun<TaskId, Fun<Long, Boolean>> reopened,
      Fun<TaskId, Long> finishes,
      Fun<RobotId, Fun<TaskId, Long>> told) {

    private States with_stage(Fun<TaskId, Stage> stage) {
      return new States(stage, claims, beginner, reopened, finishes, told);
    }

    private States with_claims(Fun<TaskId, Long> claims) {
      return new States(stage, claims, beginner, reopened, finishes, told);
    }

    private States with_beginner(Fun<TaskId, Fun<Long, Lift<RobotId>>> beginner) {
      return new States(stage, claims, beginner, reopened, finishes, told);
    }

    private States with_reopened(Fun<TaskId, Fun<Long, Boolean>> reopened) {
      return new States(stage, claims, beginner, reopened, finishes, told);
    }

    private States with_finishes(Fun<TaskId, Long> finishes) {
      return new States(stage, claims, beginner, reopened, finishes, told);
    }

    private States with_told(Fun<RobotId, Fun<TaskId, Long>> told) {
      return new States(stage, claims, beginner, reopened, finishes, told);
    }
  }

  @Override
  public String theory() {
    return LEDGER_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(new Stage.absent()),
        Fun.always(0L),
        Fun.always(Fun.always(new Lift.bottom<>())),
        Fun.always(Fun.always(false)),
        Fun.always(0L),
        Fun.always(Fun.always(0L)));
  }

  @Override
  public Enabled enabled(LedgerAction action, States s) {
    return switch (action) {
      case LedgerAction.insert a ->
          Enabled.when(
              "stage(t) = absent",
              s.stage.at(a.t()).equals(new Stage.absent()),
              () -> "stage(" + a.t() + ") = " + s.stage.at(a.t()));
      case LedgerAction.take a ->
          Enabled.when(
                  "stage(t) = open",
                  s.stage.at(a.t()).equals(new Stage.open()),
                  () -> "stage(" + a.t() + ") = " + s.stage.at(a.t()))
              .and(
                  "n = claims(t) + 1",
                  a.n() == s.claims.at(a.t()) + 1,
                  () -> "claims(" + a.t() + ") = " + s.claims.at(a.t()));
      case LedgerAction.commit a ->
          Enabled.when(
                  "stage(t) = claimed(i)",
                  s.stage.at(a.t()).equals(new Stage.claimed(a.i())),
                  () -> "stage(" + a.t() + ") = " + s.stage.at(a.t()))
              .and(
                  "n = claims(t)",
                  a.n() == s.claims.at(a.t()),
                  () -> "claims(" + a.t() + ") = " + s.claims.at(a.t()));
      case LedgerAction.finish a ->
          Enabled.when(
                  "stage(t) = begun(i)",
                  s.stage.at(a.t()).equals(new Stage.begun(a.i())),
                  () -> "stage(" + a.t() + ") = " + s.stage.at(a.t()))
              .and(
                  "n = claims(t)",
                  a.n() == s.claims.at(a.t()),
                  () -> "claims(" + a.t() + ") = " + s.claims.at(a.t()));
      case LedgerAction.free a ->
          Enabled.when(
                  "stage(t) is claimed",
                  s.stage.at(a.t()) instanceof Stage.claimed,
                  () -> "stage(" + a.t() + ") = " + s.stage.at(a.t()))
              .and(
                  "n = claims(t)",
                  a.n() == s.claims.at(a.t()),
                  () -> "claims(" + a.t() + ") = " + s.claims.at(a.t()));
      case LedgerAction.reopen a ->
          Enabled.when(
                  "stage(t) is begun",
                  s.stage.at(a.t()) instanceof Stage.begun,
                  () -> "stage(" + a.t() + ") = " + s.stage.at(a.t()))
              .and(
                  "n = claims(t)",
                  a.n() == s.claims.at(a.t()),
                  () -> "claims(" + a.t() + ") = " + s.claims.at(a.t()));
      case LedgerAction.tell a ->
          Enabled.when(
              "beginner(t, n) = some(i)",
              s.beginner.at(a.t()).at(a.n()).equals(new Lift.up<>(a.i())),
              () ->
                  String.format(
                      "beginner(%s, %s) = %s", a.t(), a.n(), s.beginner.at(a.t()).at(a.n())));
      case LedgerAction.restart a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(LedgerAction action, States s) {
    return switch (action) {
      case LedgerAction.insert a -> s.with_stage(s.stage.with(a.t(), new Stage.open()));
      case LedgerAction.take a ->
          s.with_stage(s.stage.with(a.t(), new Stage.claimed(a.i())))
              .with_claims(s.claims.with(a.t(), a.n()));
      case LedgerAction.commit a ->
          s.with_stage(s.stage.with(a.t(), new Stage.begun(a.i())))
              .with_beginner(
                  s.beginner.with(a.t(), s.beginner.at(a.t()).with(a.n(), new Lift.up<>(a.i()))));
      case LedgerAction.finish a ->
          s.with_stage(s.stage.with(a.t(), new Stage.finished()))
              .with_finishes(s.finishes.with(a.t(), s.finishes.at(a.t()) + 1));
      case LedgerAction.free a -> s.with_stage(s.stage.with(a.t(), new Stage.open()));
      case LedgerAction.reopen a ->
          s.with_stage(s.stage.with(a.t(), new Stage.open()))
              .with_reopened(s.reopened.with(a.t(), s.reopened.at(a.t()).with(a.n(), true)));
      case LedgerAction.tell a ->
          s.with_told(s.told.with(a.i(), s.told.at(a.i()).with(a.t(), a.n())));
      case LedgerAction.restart a ->
          s.with_stage(
                  Finite.map(
                      Fun.always(
                          s.stage.defaultValue().equals(new Stage.claimed(a.i()))
                              ? new Stage.open()
                              : s.stage.defaultValue()),
                      t ->
                          s.stage.at(t).equals(new Stage.claimed(a.i()))
                              ? new Stage.open()
                              : s.stage.at(t),
                      s.stage.arguments()))
              .with_told(s.told.with(a.i(), Fun.always(0L)));
    };
  }
}
