// Generated from Election_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.election;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Sets;

/**
 * The automaton Election_decls, executable.
 *
 * <p>Leader election (paper, section 4.4): at most one leader for each term.
 *
 * <p>Terms are numbered. Who has called do_election may stand in any term; one of those who stand
 * in it is elected; whoever is told of a term is told the one elected in it. Leader(i) is null,
 * fail, or a term with its leader; a process may know an old term while others know later ones.
 *
 * <p>Nothing is assumed. PIDS are ids: a robot that restarts takes part under another one. Java:
 * org.starl.primitives.election.Election; `elected' is what is true of the whole system,
 * `Leader(i)' is what i shows; this automaton: ElectionAutomaton; monitors: ElectionSpec,
 * ElectionConformance.
 */
public final class ElectionAutomaton
    implements Automaton<ElectionAutomaton.States, ElectionAction> {

  /** The theory's name. */
  public static final String ELECTION_DECLS = "Election_decls";

  /** who = none: null or fail */
  public record Known(long term, Lift<ProcessId> who) implements Comparable<Known> {

    @Override
    public int compareTo(Known that) {
      int order = Sets.compare(this.term, that.term);
      if (order == 0) {
        order = Sets.compare(this.who, that.who);
      }
      return order;
    }
  }

  /**
   * The states.
   *
   * @param part called do_election
   */
  public record States(
      SortedSet<ProcessId> part,
      Fun<Long, SortedSet<ProcessId>> stood,
      Fun<Long, Lift<ProcessId>> elected,
      Fun<ProcessId, Known> Leader) {}

  @Override
  public String theory() {
    return ELECTION_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Sets.emptyset(),
        Fun.always(Sets.emptyset()),
        Fun.always(new Lift.bottom<>()),
        Fun.always(new Known(0L, new Lift.bottom<>())));
  }

  @Override
  public Enabled enabled(ElectionAction action, States s) {
    return switch (action) {
      case ElectionAction.do_election a -> Enabled.TRUE;
      case ElectionAction.candidate a ->
          Enabled.when("i in part", s.part.contains(a.i()), () -> "part = " + s.part);
      case ElectionAction.elect a ->
          Enabled.when(
                  "elected(n) = none",
                  !s.elected.at(a.n()).isUp(),
                  () -> "elected(" + a.n() + ") = " + s.elected.at(a.n()))
              .and(
                  "i in stood(n)",
                  s.stood.at(a.n()).contains(a.i()),
                  () -> "stood(" + a.n() + ") = " + s.stood.at(a.n()));
      case ElectionAction.learn a ->
          Enabled.when(
              "elected(n) != none",
              s.elected.at(a.n()).isUp(),
              () -> "elected(" + a.n() + ") = " + s.elected.at(a.n()));
      case ElectionAction.fail a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(ElectionAction action, States s) {
    return switch (action) {
      case ElectionAction.do_election a ->
          new States(Sets.add(a.i(), s.part), s.stood, s.elected, s.Leader);
      case ElectionAction.candidate a ->
          new States(
              s.part, s.stood.with(a.n(), Sets.add(a.i(), s.stood.at(a.n()))), s.elected, s.Leader);
      case ElectionAction.elect a ->
          new States(s.part, s.stood, s.elected.with(a.n(), new Lift.up<>(a.i())), s.Leader);
      case ElectionAction.learn a ->
          new States(
              s.part,
              s.stood,
              s.elected,
              s.Leader.with(a.i(), new Known(a.n(), s.elected.at(a.n()))));
      case ElectionAction.fail a ->
          new States(
              s.part,
              s.stood,
              s.elected,
              s.Leader.with(a.i(), new Known(s.Leader.at(a.i()).term(), new Lift.bottom<>())));
    };
  }
}
