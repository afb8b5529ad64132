// Generated from Pipeline_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Undefined;

/**
 * The automaton Pipeline_decls, executable.
 *
 * <p>Mutual exclusion on sequences of zones, ordered and pipelined: the abstract specification,
 * with any number of processes.
 *
 * <p>A process asks for a list of different zones. They are granted one by one, in the order of the
 * list; so a process holds some while it waits for others, and it gives each back when its body has
 * left it. All zones have one order of requests, that of their tickets: logical times, with the
 * process id where two are equal.
 *
 * <p>A new request may have an earlier ticket than requests that wait. It is late if one of these
 * holds a zone that it needs. A late request is granted nothing, and it holds nothing: it can be
 * withdrawn without giving up a place, and made anew with a later ticket. If no request is late,
 * then each waits for earlier tickets and for processes that do not wait: no circle of processes
 * wait for each other.
 *
 * <p>A program may begin anew after a crash: what it held then, its body may still stand in, until
 * the program says where its body is. As long as there is such a rest, the robot resumes: it is
 * granted free zones out of the order of tickets, since the others would wait for its body. What it
 * holds stays exclusive. A request that it makes late may still be granted zones that it does not
 * wait for. Not claimed of a resumed robot, and of a request that it makes late: that a late
 * request holds nothing. Nor is it claimed that the wait for a body ends.
 *
 * <p>What is asked of the caller (do_sequence and stands_in with sense, release of what is held)
 * stands in the enabling conditions. Java: this automaton is PipelineAutomaton.
 */
public final class PipelineAutomaton
    implements Automaton<PipelineAutomaton.States, PipelineAction> {

  /** The theory's name. */
  public static final String PIPELINE_DECLS = "Pipeline_decls";

  /**
   * The states.
   *
   * @param crit_set held by the present program
   * @param req asked for and not yet granted, in order
   * @param rest_set held by earlier starts of i's program
   * @param ticket of i's newest request
   * @param resumed the newest request was granted a zone out of order
   */
  public record States(
      Fun<RobotId, SortedSet<String>> crit_set,
      Fun<RobotId, List<String>> req,
      Fun<RobotId, SortedSet<String>> rest_set,
      Fun<RobotId, Long> ticket,
      SortedSet<RobotId> resumed) {

    public SortedSet<String> held(RobotId i) {
      return Sets.union(crit_set.at(i), rest_set.at(i));
    }

    public boolean isWaits(RobotId i) {
      return !req.at(i).isEmpty();
    }

    /** Nobody else holds z. */
    public boolean isFreeFor(RobotId i, String z) {
      return Finite.forAll(
              j -> i.equals(j) || !held(j).contains(z),
              List.of(i),
              crit_set.arguments(),
              rest_set.arguments())
          && !Sets.union(crit_set.defaultValue(), rest_set.defaultValue()).contains(z);
    }

    /** i's ticket is earlier than that of j, which waits and holds a zone that i needs. */
    public boolean isLateFor(RobotId i, RobotId j) {
      return isWaits(i)
          && isWaits(j)
          && ticket.at(i) < ticket.at(j)
          && !Sets.disjoint(Sets.of(req.at(i)), crit_set.at(j));
    }

    public boolean isLate(RobotId i) {
      return Finite.exists(
              j -> isLateFor(i, j), req.arguments(), ticket.arguments(), crit_set.arguments())
          || (isWaits(i)
              && !req.defaultValue().isEmpty()
              && ticket.at(i) < ticket.defaultValue()
              && !Sets.disjoint(Sets.of(req.at(i)), crit_set.defaultValue()));
    }

    /**
     * i is late, and may not be granted z: a process that makes it late holds what it holds in the
     * order of tickets, or waits for z.
     */
    public boolean isBarred(RobotId i, String z) {
      return Finite.exists(
              j -> isLateFor(i, j) && (!resumed.contains(j) || Sets.of(req.at(j)).contains(z)),
              req.arguments(),
              ticket.arguments(),
              crit_set.arguments(),
              resumed)
          || (isWaits(i)
              && !req.defaultValue().isEmpty()
              && ticket.at(i) < ticket.defaultValue()
              && !Sets.disjoint(Sets.of(req.at(i)), crit_set.defaultValue()));
    }

    /** j holds zones, and is to be granted z before i is. */
    public boolean isBefore(RobotId j, RobotId i, String z) {
      return isWaits(j)
          && Sets.of(req.at(j)).contains(z)
          && ticket.at(j) < ticket.at(i)
          && !crit_set.at(j).isEmpty();
    }

    /** i waits for j: for a zone that j holds, or is to be granted before i. */
    public boolean isWaitsFor(RobotId i, RobotId j) {
      return isWaits(i)
          && !i.equals(j)
          && (held(j).contains(Undefined.head("Pipeline_decls.starl:71:32", req.at(i)))
              || isBefore(j, i, Undefined.head("Pipeline_decls.starl:71:73", req.at(i))));
    }
  }

  @Override
  public String theory() {
    return PIPELINE_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Sets.emptyset()),
        Fun.always(List.of()),
        Fun.always(Sets.emptyset()),
        Fun.always(0L),
        Sets.emptyset());
  }

  @Override
  public Enabled enabled(PipelineAction action, States s) {
    return switch (action) {
      case PipelineAction.do_sequence a ->
          Enabled.when("L != []", !a.L().isEmpty(), () -> "L = " + a.L())
              .and("distinct(L)", Sets.of(a.L()).size() == a.L().size(), () -> "L = " + a.L())
              .and(
                  "req(i) = []",
                  s.req.at(a.i()).isEmpty(),
                  () -> "req(" + a.i() + ") = " + s.req.at(a.i()))
              .and(
                  "crit_set(i) = {}",
                  s.crit_set.at(a.i()).isEmpty(),
                  () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()))
              .and(
                  "forall j: PIDS :: waits?(j) => not t = ticket(j)",
                  Finite.forAll(
                          j -> !s.isWaits(j) || a.t() != s.ticket.at(j),
                          s.req.arguments(),
                          s.ticket.arguments())
                      && (s.req.defaultValue().isEmpty() || a.t() != s.ticket.defaultValue()),
                  () ->
                      Finite.first(
                          j -> !(!s.isWaits(j) || a.t() != s.ticket.at(j)),
                          j ->
                              String.format(
                                  "req(%s) = %s, ticket(%s) = %s",
                                  j, s.req.at(j), j, s.ticket.at(j)),
                          s.req.arguments(),
                          s.ticket.arguments()));
      case PipelineAction.grant a ->
          Enabled.when(
                  "req(i) != []",
                  !s.req.at(a.i()).isEmpty(),
                  () -> "req(" + a.i() + ") = " + s.req.at(a.i()))
              .and(
                  "z = head(req(i))",
                  () -> a.z().equals(Undefined.head("Pipeline_decls.starl:79:25", s.req.at(a.i()))),
                  () -> "req(" + a.i() + ") = " + s.req.at(a.i()))
              .and(
                  "free_for?(i, z)",
                  s.isFreeFor(a.i(), a.z()),
                  () ->
                      Finite.first(
                          j -> !(a.i().equals(j) || !s.held(j).contains(a.z())),
                          j -> "held(" + j + ") = " + s.held(j),
                          List.of(a.i()),
                          s.crit_set.arguments(),
                          s.rest_set.arguments()))
              .and(
                  "barred?(i, z) => rest_set(i) != {}",
                  !s.isBarred(a.i(), a.z()) || !s.rest_set.at(a.i()).isEmpty(),
                  () -> "rest_set(" + a.i() + ") = " + s.rest_set.at(a.i()))
              .and(
                  "forall j: PIDS :: before?(j, i, z) => rest_set(i) != {}",
                  Finite.forAll(
                          j -> !s.isBefore(j, a.i(), a.z()) || !s.rest_set.at(a.i()).isEmpty(),
                          s.req.arguments(),
                          s.ticket.arguments(),
                          s.crit_set.arguments())
                      && (!(!s.req.defaultValue().isEmpty()
                              && Sets.of(s.req.defaultValue()).contains(a.z())
                              && s.ticket.defaultValue() < s.ticket.at(a.i())
                              && !s.crit_set.defaultValue().isEmpty())
                          || !s.rest_set.at(a.i()).isEmpty()),
                  () ->
                      Finite.first(
                          j -> !(!s.isBefore(j, a.i(), a.z()) || !s.rest_set.at(a.i()).isEmpty()),
                          j ->
                              String.format(
                                  "req(%s) = %s, ticket(%s) = %s, ticket(%s) = %s, crit_set(%s) = %s, rest_set(%s) = %s",
                                  j,
                                  s.req.at(j),
                                  j,
                                  s.ticket.at(j),
                                  a.i(),
                                  s.ticket.at(a.i()),
                                  j,
                                  s.crit_set.at(j),
                                  a.i(),
                                  s.rest_set.at(a.i())),
                          s.req.arguments(),
                          s.ticket.arguments(),
                          s.crit_set.arguments()));
      case PipelineAction.release a ->
          Enabled.when(
              "RS subset crit_set(i)",
              s.crit_set.at(a.i()).containsAll(a.RS()),
              () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()));
      case PipelineAction.withdraw a ->
          Enabled.when(
              "req(i) != []",
              !s.req.at(a.i()).isEmpty(),
              () -> "req(" + a.i() + ") = " + s.req.at(a.i()));
      case PipelineAction.restart a -> Enabled.TRUE;
      case PipelineAction.stands_in a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(PipelineAction action, States s) {
    return switch (action) {
      case PipelineAction.do_sequence a ->
          new States(
              s.crit_set,
              s.req.with(a.i(), a.L()),
              s.rest_set,
              s.ticket.with(a.i(), a.t()),
              Sets.remove(a.i(), s.resumed));
      case PipelineAction.grant a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.crit_set.with(a.i(), Sets.add(a.z(), s.crit_set.at(a.i()))),
                  s.req.with(a.i(), Undefined.tail("Pipeline_decls.starl:82:55", s.req.at(a.i()))),
                  s.rest_set,
                  s.ticket,
                  s.rest_set.at(a.i()).isEmpty() ? s.resumed : Sets.add(a.i(), s.resumed))
              : s;
      case PipelineAction.release a ->
          new States(
              s.crit_set.with(a.i(), Sets.difference(s.crit_set.at(a.i()), a.RS())),
              s.req,
              s.rest_set,
              s.ticket,
              s.resumed);
      case PipelineAction.withdraw a ->
          new States(s.crit_set, s.req.with(a.i(), List.of()), s.rest_set, s.ticket, s.resumed);
      case PipelineAction.restart a ->
          new States(
              s.crit_set.with(a.i(), Sets.emptyset()),
              s.req.with(a.i(), List.of()),
              s.rest_set.with(a.i(), s.held(a.i())),
              s.ticket,
              s.resumed);
      case PipelineAction.stands_in a ->
          new States(
              s.crit_set,
              s.req,
              s.rest_set.with(a.i(), Sets.intersection(s.rest_set.at(a.i()), a.RS())),
              s.ticket,
              s.resumed);
    };
  }
}
