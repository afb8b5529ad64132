// Generated from MutexProtocol_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import java.util.function.BiPredicate;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The automaton MutexProtocol_decls, executable.
 *
 * <p>Mutual exclusion by messages, among processes whose lists change: Ricart and Agrawala's
 * algorithm ("An optimal algorithm for mutual exclusion in computer networks", CACM 1981) on sets
 * of zones, where each process asks those on its list.
 *
 * <p>A request carries a logical time. All on the list of the requester have to grant it, and so
 * have those whose requests it has granted before: they may be on a later list than its own. A
 * process keeps its grant back while it holds a zone that is asked for, or waits for one with an
 * earlier time.
 *
 * <p>The network is the set of all messages ever sent. A message may be acted on at any later time,
 * in any order, more than once, or never: so delay, loss, duplication, reordering and partition are
 * covered, and so is a process that crashes: it acts no more, and keeps what it holds. A robot that
 * starts again is another process.
 *
 * <p>A process that has crashed, or seems to have, answers nobody. Another one fences it: it grants
 * it nothing any more, and the fenced process cannot enter without. So whoever has fenced it knows
 * the most that it may hold, now and later: what it has granted it. It vouches for it to all who
 * ask for other zones. A new process of a robot fences the robot's earlier ones.
 *
 * <p>Assumed: what Mutex_group_decls assumes of its caller (connects?), and that a process leaves
 * out of its lists only who holds and waits for nothing (forget). Both follow from Keeps of
 * Registration_decls. Not here: modes and sequences.
 *
 * <p>Java: org.starl.primitives.mutex.MutexProtocol and Fences; each run is replayed on this
 * automaton: ProtocolConformance.
 */
public final class ProtocolAutomaton
    implements Automaton<ProtocolAutomaton.States, ProtocolAction> {

  /** The theory's name. */
  public static final String MUTEX_PROTOCOL_DECLS = "MutexProtocol_decls";

  private final BiPredicate<ProcessId, ProcessId> before;

  /** Of the theory's parameters. */
  public ProtocolAutomaton(BiPredicate<ProcessId, ProcessId> before) {
    this.before = before;
  }

  public enum Phase {
    idle,
    trying,
    critical
  }

  public record Request(ProcessId asker, long at, SortedSet<String> zones)
      implements Comparable<Request> {

    @Override
    public int compareTo(Request that) {
      return Sets.compare(
          List.of(this.asker, this.at, this.zones), List.of(that.asker, that.at, that.zones));
    }
  }

  public record Grant(ProcessId giver, ProcessId asker, long at) implements Comparable<Grant> {

    @Override
    public int compareTo(Grant that) {
      return Sets.compare(
          List.of(this.giver, this.asker, this.at), List.of(that.giver, that.asker, that.at));
    }
  }

  /**
   * The states.
   *
   * @param ts of its newest request
   * @param want waits for, or holds
   * @param plist its list
   * @param heard whose requests it has granted
   * @param fencers who grants it nothing any more
   * @param vouched in the place of the giver
   */
  public record States(
      Fun<ProcessId, Long> clock,
      Fun<ProcessId, Phase> phase,
      Fun<ProcessId, Long> ts,
      Fun<ProcessId, SortedSet<String>> want,
      Fun<ProcessId, SortedSet<ProcessId>> plist,
      Fun<ProcessId, SortedSet<ProcessId>> heard,
      SortedSet<Request> reqs,
      SortedSet<Grant> oks,
      Fun<ProcessId, SortedSet<ProcessId>> fencers,
      SortedSet<Grant> vouched) {

    /** j has granted i's request of time t. */
    public boolean isGranted(ProcessId j, ProcessId i, long t) {
      return oks.contains(new Grant(j, i, t));
    }

    /** Somebody has vouched for j to i. */
    public boolean isVouched(ProcessId j, ProcessId i, long t) {
      return vouched.contains(new Grant(j, i, t));
    }

    /** What i may hold at most until its next request, as f knows that has fenced it. */
    public SortedSet<String> at_most(ProcessId i, ProcessId f) {
      return phase.at(i) == Phase.trying && !isGranted(f, i, ts.at(i))
          ? Sets.emptyset()
          : want.at(i);
    }

    public boolean isActive(ProcessId i) {
      return phase.at(i) != Phase.idle;
    }

    public boolean isPeer(ProcessId i, ProcessId j) {
      return plist.at(i).contains(j) || plist.at(j).contains(i);
    }

    /** What is asked of the caller. */
    public boolean isConnects(ProcessId i, SortedSet<ProcessId> P) {
      return Finite.forAll(
              j -> !(!i.equals(j) && isActive(j)) || P.contains(j) || plist.at(j).contains(i),
              List.of(i),
              phase.arguments(),
              P,
              plist.arguments())
          && (phase.defaultValue() == Phase.idle || plist.defaultValue().contains(i));
    }

    private States with_clock(Fun<ProcessId, Long> clock) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_phase(Fun<ProcessId, Phase> phase) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_ts(Fun<ProcessId, Long> ts) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_want(Fun<ProcessId, SortedSet<String>> want) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_plist(Fun<ProcessId, SortedSet<ProcessId>> plist) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_heard(Fun<ProcessId, SortedSet<ProcessId>> heard) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_reqs(SortedSet<Request> reqs) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_oks(SortedSet<Grant> oks) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_fencers(Fun<ProcessId, SortedSet<ProcessId>> fencers) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_vouched(SortedSet<Grant> vouched) {
      return new States(clock, phase, ts, want, plist, heard, reqs, oks, fencers, vouched);
    }
  }

  @Override
  public String theory() {
    return MUTEX_PROTOCOL_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(0L),
        Fun.always(Phase.idle),
        Fun.always(0L),
        Fun.always(Sets.emptyset()),
        Fun.always(Sets.emptyset()),
        Fun.always(Sets.emptyset()),
        Sets.emptyset(),
        Sets.emptyset(),
        Fun.always(Sets.emptyset()),
        Sets.emptyset());
  }

  /** The request of time t by i goes first, before that of time u by j. */
  public boolean isFirst(long t, ProcessId i, long u, ProcessId j) {
    return t < u || (t == u && before.test(i, j));
  }

  /** j does not grant now the request of time t by i for RS. */
  public boolean isKeepsBack(ProcessId j, ProcessId i, long t, SortedSet<String> RS, States s) {
    return s.phase.at(j) != Phase.idle
        && Finite.exists(z -> s.want.at(j).contains(z) && RS.contains(z), s.want.at(j))
        && (s.phase.at(j) == Phase.critical || isFirst(s.ts.at(j), j, t, i));
  }

  @Override
  public Enabled enabled(ProtocolAction action, States s) {
    return switch (action) {
      case ProtocolAction.request a ->
          Enabled.when(
                  "phase(i) = idle",
                  s.phase.at(a.i()) == Phase.idle,
                  () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()))
              .and("RS != {}", !a.RS().isEmpty(), () -> "RS = " + a.RS())
              .and(
                  "connects?(i, P)",
                  s.isConnects(a.i(), a.P()),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j) && s.isActive(j))
                                  || a.P().contains(j)
                                  || s.plist.at(j).contains(a.i())),
                          j ->
                              String.format(
                                  "phase(%s) = %s, plist(%s) = %s",
                                  j, s.phase.at(j), j, s.plist.at(j)),
                          List.of(a.i()),
                          s.phase.arguments(),
                          a.P(),
                          s.plist.arguments()));
      case ProtocolAction.known a ->
          Enabled.when(
                  "phase(i) = trying",
                  s.phase.at(a.i()) == Phase.trying,
                  () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()))
              .and(
                  "connects?(i, P)",
                  s.isConnects(a.i(), a.P()),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j) && s.isActive(j))
                                  || a.P().contains(j)
                                  || s.plist.at(j).contains(a.i())),
                          j ->
                              String.format(
                                  "phase(%s) = %s, plist(%s) = %s",
                                  j, s.phase.at(j), j, s.plist.at(j)),
                          List.of(a.i()),
                          s.phase.arguments(),
                          a.P(),
                          s.plist.arguments()));
      case ProtocolAction.forget a ->
          Enabled.when(
              "not active?(j)",
              !s.isActive(a.j()),
              () -> "phase(" + a.j() + ") = " + s.phase.at(a.j()));
      case ProtocolAction.grant a ->
          Enabled.when("not i = j", !a.i().equals(a.j()), () -> "i = " + a.i() + ", j = " + a.j())
              .and(
                  "Request(asker := i, at := t, zones := RS) in reqs",
                  s.reqs.contains(new Request(a.i(), a.t(), a.RS())),
                  () -> "reqs = " + s.reqs)
              .and(
                  "not j in fencers(i)",
                  !s.fencers.at(a.i()).contains(a.j()),
                  () -> "fencers(" + a.i() + ") = " + s.fencers.at(a.i()))
              .and(
                  "not keeps_back?(j, i, t, RS)",
                  !isKeepsBack(a.j(), a.i(), a.t(), a.RS(), s),
                  () ->
                      String.format(
                          "phase(%s) = %s, %s",
                          a.j(),
                          s.phase.at(a.j()),
                          s.phase.at(a.j()) == Phase.critical
                              ? "phase(" + a.j() + ") = " + s.phase.at(a.j())
                              : "ts(" + a.j() + ") = " + s.ts.at(a.j())));
      case ProtocolAction.enter a ->
          Enabled.when(
                  "phase(i) = trying",
                  s.phase.at(a.i()) == Phase.trying,
                  () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()))
              .and(
                  "forall j: PIDS :: not i = j and (j in plist(i) or j in heard(i)) => granted?(j, i, ts(i)) or vouched?(j, i, ts(i))",
                  Finite.forAll(
                      j ->
                          !(!a.i().equals(j)
                                  && (s.plist.at(a.i()).contains(j)
                                      || s.heard.at(a.i()).contains(j)))
                              || s.isGranted(j, a.i(), s.ts.at(a.i()))
                              || s.isVouched(j, a.i(), s.ts.at(a.i())),
                      s.plist.at(a.i()),
                      s.heard.at(a.i())),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j)
                                      && (s.plist.at(a.i()).contains(j)
                                          || s.heard.at(a.i()).contains(j)))
                                  || s.isGranted(j, a.i(), s.ts.at(a.i()))
                                  || s.isVouched(j, a.i(), s.ts.at(a.i()))),
                          j ->
                              String.format(
                                  "j = %s, %s, ts(%s) = %s, oks = %s, vouched = %s",
                                  j,
                                  s.plist.at(a.i()).contains(j)
                                      ? "plist(" + a.i() + ") = " + s.plist.at(a.i())
                                      : "heard(" + a.i() + ") = " + s.heard.at(a.i()),
                                  a.i(),
                                  s.ts.at(a.i()),
                                  s.oks,
                                  s.vouched),
                          s.plist.at(a.i()),
                          s.heard.at(a.i())))
              .and(
                  "forall f: PIDS :: f in fencers(i) => granted?(f, i, ts(i))",
                  Finite.forAll(
                      f ->
                          !s.fencers.at(a.i()).contains(f) || s.isGranted(f, a.i(), s.ts.at(a.i())),
                      s.fencers.at(a.i())),
                  () ->
                      Finite.first(
                          f ->
                              !(!s.fencers.at(a.i()).contains(f)
                                  || s.isGranted(f, a.i(), s.ts.at(a.i()))),
                          f ->
                              String.format(
                                  "f = %s, fencers(%s) = %s, ts(%s) = %s, oks = %s",
                                  f, a.i(), s.fencers.at(a.i()), a.i(), s.ts.at(a.i()), s.oks),
                          s.fencers.at(a.i())));
      case ProtocolAction.release a ->
          Enabled.when(
                  "phase(i) = critical",
                  s.phase.at(a.i()) == Phase.critical,
                  () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()))
              .and(
                  "RS subset want(i)",
                  s.want.at(a.i()).containsAll(a.RS()),
                  () -> "want(" + a.i() + ") = " + s.want.at(a.i()));
      case ProtocolAction.withdraw a ->
          Enabled.when(
              "phase(i) = trying",
              s.phase.at(a.i()) == Phase.trying,
              () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()));
      case ProtocolAction.fence a -> Enabled.TRUE;
      case ProtocolAction.vouch a ->
          Enabled.when(
                  "f in fencers(j)",
                  s.fencers.at(a.j()).contains(a.f()),
                  () -> "fencers(" + a.j() + ") = " + s.fencers.at(a.j()))
              .and(
                  "Request(asker := i, at := t, zones := RS) in reqs",
                  s.reqs.contains(new Request(a.i(), a.t(), a.RS())),
                  () -> "reqs = " + s.reqs)
              .and(
                  "RS disjoint at_most(j, f)",
                  Sets.disjoint(a.RS(), s.at_most(a.j(), a.f())),
                  () ->
                      String.format("at_most(%s, %s) = %s", a.j(), a.f(), s.at_most(a.j(), a.f())));
      case ProtocolAction.witness a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(ProtocolAction action, States s) {
    return switch (action) {
      case ProtocolAction.request a ->
          s.with_clock(s.clock.with(a.i(), s.clock.at(a.i()) + 1))
              .with_phase(s.phase.with(a.i(), Phase.trying))
              .with_ts(s.ts.with(a.i(), s.clock.at(a.i()) + 1))
              .with_want(s.want.with(a.i(), a.RS()))
              .with_plist(s.plist.with(a.i(), a.P()))
              .with_reqs(Sets.add(new Request(a.i(), s.clock.at(a.i()) + 1, a.RS()), s.reqs));
      case ProtocolAction.known a -> s.with_plist(s.plist.with(a.i(), a.P()));
      case ProtocolAction.forget a ->
          s.with_heard(s.heard.with(a.i(), Sets.remove(a.j(), s.heard.at(a.i()))));
      case ProtocolAction.grant a ->
          s.with_clock(s.clock.with(a.j(), s.clock.at(a.j()) < a.t() ? a.t() : s.clock.at(a.j())))
              .with_heard(s.heard.with(a.j(), Sets.add(a.i(), s.heard.at(a.j()))))
              .with_oks(Sets.add(new Grant(a.j(), a.i(), a.t()), s.oks));
      case ProtocolAction.enter a -> s.with_phase(s.phase.with(a.i(), Phase.critical));
      case ProtocolAction.release a ->
          s.with_phase(
                  s.phase.with(
                      a.i(), a.RS().containsAll(s.want.at(a.i())) ? Phase.idle : Phase.critical))
              .with_want(s.want.with(a.i(), Sets.difference(s.want.at(a.i()), a.RS())));
      case ProtocolAction.withdraw a ->
          s.with_phase(s.phase.with(a.i(), Phase.idle))
              .with_want(s.want.with(a.i(), Sets.emptyset()));
      case ProtocolAction.fence a ->
          s.with_fencers(s.fencers.with(a.i(), Sets.add(a.f(), s.fencers.at(a.i()))));
      case ProtocolAction.vouch a ->
          s.with_vouched(Sets.add(new Grant(a.j(), a.i(), a.t()), s.vouched));
      case ProtocolAction.witness a ->
          s.with_clock(s.clock.with(a.i(), s.clock.at(a.i()) < a.t() ? a.t() : s.clock.at(a.i())));
    };
  }
}
