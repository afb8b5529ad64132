package org.starl.primitives.election;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Sets;

/**
 * The theory {@code Election_decls} as an executable automaton: at most one leader for each term. {@code
 * PIDS} are ids, one for each start of a robot's program. {@link ElectionConformance} replays runs on it.
 */
public final class ElectionAutomaton
    implements Automaton<ElectionAutomaton.States, ElectionAction> {

  /** The theory's name. */
  public static final String ELECTION_DECLS = "Election_decls";

  /**
   * The leader that an id knows.
   *
   * @param who the leader; bottom for null or fail
   */
  public record Known(long term, Lift<ProcessId> who) {

    /** {@code (# term := 1, who := up(bot0#1) #)}. */
    @Override
    public String toString() {
      return "(# term := " + term + ", who := " + who + " #)";
    }
  }

  /**
   * The theory's states.
   *
   * @param part whether an id has called {@code do_election}
   * @param stood the candidates of a term
   * @param elected the leader of a term
   * @param Leader the leader that an id shows
   */
  public record States(
      Fun<ProcessId, Boolean> part,
      Fun<Long, SortedSet<ProcessId>> stood,
      Fun<Long, Lift<ProcessId>> elected,
      Fun<ProcessId, Known> Leader) {

    private States withLeader(ProcessId i, Known known) {
      return new States(part, stood, elected, Leader.with(i, known));
    }
  }

  @Override
  public String theory() {
    return ELECTION_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(false),
        Fun.always(Sets.emptyset()),
        Fun.always(new Lift.bottom<>()),
        Fun.always(new Known(0, new Lift.bottom<>())));
  }

  @Override
  public Enabled enabled(ElectionAction action, States s) {
    return switch (action) {
      case ElectionAction.do_election a -> Enabled.TRUE;
      case ElectionAction.candidate a ->
          Enabled.when("part(i)", s.part.at(a.i()), () -> "NOT part(" + a.i() + ")");
      case ElectionAction.elect a ->
          Enabled.when(
                  "bottom?(elected(n))",
                  !s.elected.at(a.n()).isUp(),
                  () -> "elected(" + a.n() + ") = " + s.elected.at(a.n()))
              .and(
                  "stood(n)(i)",
                  s.stood.at(a.n()).contains(a.i()),
                  () -> "stood(" + a.n() + ") = " + s.stood.at(a.n()));
      case ElectionAction.learn a ->
          Enabled.when(
              "up?(elected(n))",
              s.elected.at(a.n()).isUp(),
              () -> "elected(" + a.n() + ") = " + s.elected.at(a.n()));
      case ElectionAction.fail a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(ElectionAction action, States s) {
    return switch (action) {
      case ElectionAction.do_election a ->
          new States(s.part.with(a.i(), true), s.stood, s.elected, s.Leader);
      case ElectionAction.candidate a -> {
        SortedSet<ProcessId> stood = Sets.add(a.i(), s.stood.at(a.n()));
        yield new States(s.part, s.stood.with(a.n(), stood), s.elected, s.Leader);
      }
      case ElectionAction.elect a ->
          new States(s.part, s.stood, s.elected.with(a.n(), new Lift.up<>(a.i())), s.Leader);
      case ElectionAction.learn a -> s.withLeader(a.i(), new Known(a.n(), s.elected.at(a.n())));
      case ElectionAction.fail a ->
          s.withLeader(a.i(), new Known(s.Leader.at(a.i()).term(), new Lift.bottom<>()));
    };
  }
}
