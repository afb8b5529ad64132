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
 * and on sequences of zones, where each process asks those on its list.
 *
 * <p>A request carries a logical time. All on the list of the requester have to grant it, and so
 * have those whose requests it has granted before: they may be on a later list than its own. A
 * process keeps back its grant of a zone that it holds, or that it waits for with an earlier time.
 *
 * <p>A request for a set enters all its zones at once. One for a sequence enters some of them, and
 * waits for the others while it holds these.
 *
 * <p>The network is the set of all messages ever sent. A message may be acted on at any later time,
 * in any order, more than once, or never: so delay, loss, duplication, reordering and partition are
 * covered, and so is a process that crashes: it acts no more, and keeps what it holds. A robot that
 * starts again is another process.
 *
 * <p>A process that has crashed, or seems to have, answers nobody. Another one fences it: it grants
 * it nothing any more, and the fenced process cannot enter without. So whoever has fenced it knows
 * the most that it may hold, now and later: what it holds, and what it has granted it. It vouches
 * for it to all who ask for other zones. A new process of a robot fences the robot's earlier ones.
 *
 * <p>Assumed: what Mutex_group_decls assumes of its caller (connects?), and that a process leaves
 * out of its lists only who holds and waits for nothing (forget). Both follow from Keeps of
 * Registration_decls. Not here: modes; the order of a sequence, and what a robot asks for that
 * resumes one after a restart.
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

  public record Request(ProcessId asker, long at) implements Comparable<Request> {

    @Override
    public int compareTo(Request that) {
      int order = Sets.compare(this.asker, that.asker);
      if (order == 0) {
        order = Sets.compare(this.at, that.at);
      }
      return order;
    }
  }

  public record Grant(ProcessId giver, ProcessId asker, long at, String zone)
      implements Comparable<Grant> {

    @Override
    public int compareTo(Grant that) {
      int order = Sets.compare(this.giver, that.giver);
      if (order == 0) {
        order = Sets.compare(this.asker, that.asker);
      }
      if (order == 0) {
        order = Sets.compare(this.at, that.at);
      }
      if (order == 0) {
        order = Sets.compare(this.zone, that.zone);
      }
      return order;
    }
  }

  /**
   * The states.
   *
   * @param ts of its newest request
   * @param want waits for, or holds
   * @param crit_set holds
   * @param parts its newest request is for a sequence
   * @param plist its list
   * @param heard whose requests it has granted
   * @param fencers who grants it nothing any more
   * @param vouched in the place of the giver
   */
  public record States(
      Fun<ProcessId, Long> clock,
      Fun<ProcessId, Long> ts,
      Fun<ProcessId, SortedSet<String>> want,
      Fun<ProcessId, SortedSet<String>> crit_set,
      SortedSet<ProcessId> parts,
      Fun<ProcessId, SortedSet<ProcessId>> plist,
      Fun<ProcessId, SortedSet<ProcessId>> heard,
      SortedSet<Request> reqs,
      SortedSet<Grant> oks,
      Fun<ProcessId, SortedSet<ProcessId>> fencers,
      SortedSet<Grant> vouched) {

    /** j has granted z to i's request of time t. */
    public boolean isGranted(ProcessId j, ProcessId i, long t, String z) {
      return oks.contains(new Grant(j, i, t, z));
    }

    /** Somebody has vouched for j to i. */
    public boolean isVouched(ProcessId j, ProcessId i, long t, String z) {
      return vouched.contains(new Grant(j, i, t, z));
    }

    /** i holds z at most until its next request, as f knows that has fenced it. */
    public boolean isMayHold(ProcessId i, ProcessId f, String z) {
      return crit_set.at(i).contains(z) || (want.at(i).contains(z) && isGranted(f, i, ts.at(i), z));
    }

    public boolean isActive(ProcessId i) {
      return !want.at(i).isEmpty();
    }

    public boolean isWaits(ProcessId i) {
      return !crit_set.at(i).containsAll(want.at(i));
    }

    public boolean isPeer(ProcessId i, ProcessId j) {
      return plist.at(i).contains(j) || plist.at(j).contains(i);
    }

    /** What is asked of the caller. */
    public boolean isConnects(ProcessId i, SortedSet<ProcessId> P) {
      return Finite.forAll(
              j -> !(!i.equals(j) && isActive(j)) || P.contains(j) || plist.at(j).contains(i),
              List.of(i),
              want.arguments(),
              P,
              plist.arguments())
          && (want.defaultValue().isEmpty() || plist.defaultValue().contains(i));
    }

    private States with_clock(Fun<ProcessId, Long> clock) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_ts(Fun<ProcessId, Long> ts) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_want(Fun<ProcessId, SortedSet<String>> want) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_crit_set(Fun<ProcessId, SortedSet<String>> crit_set) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_parts(SortedSet<ProcessId> parts) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_plist(Fun<ProcessId, SortedSet<ProcessId>> plist) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_heard(Fun<ProcessId, SortedSet<ProcessId>> heard) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_reqs(SortedSet<Request> reqs) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_oks(SortedSet<Grant> oks) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_fencers(Fun<ProcessId, SortedSet<ProcessId>> fencers) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
    }

    private States with_vouched(SortedSet<Grant> vouched) {
      return new States(
          clock, ts, want, crit_set, parts, plist, heard, reqs, oks, fencers, vouched);
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
        Fun.always(0L),
        Fun.always(Sets.emptyset()),
        Fun.always(Sets.emptyset()),
        Sets.emptyset(),
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

  /** j does not grant z now to the request of time t by i. */
  public boolean isKeepsBack(ProcessId j, ProcessId i, long t, String z, States s) {
    return s.want.at(j).contains(z)
        && (s.crit_set.at(j).contains(z) || isFirst(s.ts.at(j), j, t, i));
  }

  @Override
  public Enabled enabled(ProtocolAction action, States s) {
    return switch (action) {
      case ProtocolAction.request a ->
          Enabled.when(
                  "not active?(i)",
                  !s.isActive(a.i()),
                  () -> "want(" + a.i() + ") = " + s.want.at(a.i()))
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
                                  "want(%s) = %s, plist(%s) = %s",
                                  j, s.want.at(j), j, s.plist.at(j)),
                          List.of(a.i()),
                          s.want.arguments(),
                          a.P(),
                          s.plist.arguments()));
      case ProtocolAction.known a ->
          Enabled.when(
                  "waits?(i)",
                  s.isWaits(a.i()),
                  () ->
                      String.format(
                          "want(%s) = %s, crit_set(%s) = %s",
                          a.i(), s.want.at(a.i()), a.i(), s.crit_set.at(a.i())))
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
                                  "want(%s) = %s, plist(%s) = %s",
                                  j, s.want.at(j), j, s.plist.at(j)),
                          List.of(a.i()),
                          s.want.arguments(),
                          a.P(),
                          s.plist.arguments()))
              .and(
                  "crit_set(i) = {} or P subset plist(i)",
                  s.crit_set.at(a.i()).isEmpty() || s.plist.at(a.i()).containsAll(a.P()),
                  () ->
                      String.format(
                          "crit_set(%s) = %s, plist(%s) = %s",
                          a.i(), s.crit_set.at(a.i()), a.i(), s.plist.at(a.i())));
      case ProtocolAction.forget a ->
          Enabled.when(
              "not active?(j)",
              !s.isActive(a.j()),
              () -> "want(" + a.j() + ") = " + s.want.at(a.j()));
      case ProtocolAction.grant a ->
          Enabled.when("not i = j", !a.i().equals(a.j()), () -> "i = " + a.i() + ", j = " + a.j())
              .and(
                  "Request(asker := i, at := t) in reqs",
                  s.reqs.contains(new Request(a.i(), a.t())),
                  () -> "reqs = " + s.reqs)
              .and(
                  "not j in fencers(i)",
                  !s.fencers.at(a.i()).contains(a.j()),
                  () -> "fencers(" + a.i() + ") = " + s.fencers.at(a.i()))
              .and(
                  "not keeps_back?(j, i, t, z)",
                  !isKeepsBack(a.j(), a.i(), a.t(), a.z(), s),
                  () ->
                      String.format(
                          "want(%s) = %s, %s",
                          a.j(),
                          s.want.at(a.j()),
                          s.crit_set.at(a.j()).contains(a.z())
                              ? "crit_set(" + a.j() + ") = " + s.crit_set.at(a.j())
                              : "ts(" + a.j() + ") = " + s.ts.at(a.j())));
      case ProtocolAction.enter a ->
          Enabled.when(
                  "waits?(i)",
                  s.isWaits(a.i()),
                  () ->
                      String.format(
                          "want(%s) = %s, crit_set(%s) = %s",
                          a.i(), s.want.at(a.i()), a.i(), s.crit_set.at(a.i())))
              .and(
                  "G subset want(i)",
                  s.want.at(a.i()).containsAll(a.G()),
                  () -> "want(" + a.i() + ") = " + s.want.at(a.i()))
              .and(
                  "i in parts or G = want(i)",
                  s.parts.contains(a.i()) || a.G().equals(s.want.at(a.i())),
                  () ->
                      String.format("parts = %s, want(%s) = %s", s.parts, a.i(), s.want.at(a.i())))
              .and(
                  "forall j: PIDS :: not i = j and (j in plist(i) or j in heard(i)) => forall z: Zones :: z in G => granted?(j, i, ts(i), z) or vouched?(j, i, ts(i), z)",
                  Finite.forAll(
                      j ->
                          !(!a.i().equals(j)
                                  && (s.plist.at(a.i()).contains(j)
                                      || s.heard.at(a.i()).contains(j)))
                              || Finite.forAll(
                                  z ->
                                      !a.G().contains(z)
                                          || s.isGranted(j, a.i(), s.ts.at(a.i()), z)
                                          || s.isVouched(j, a.i(), s.ts.at(a.i()), z),
                                  a.G()),
                      s.plist.at(a.i()),
                      s.heard.at(a.i())),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j)
                                      && (s.plist.at(a.i()).contains(j)
                                          || s.heard.at(a.i()).contains(j)))
                                  || Finite.forAll(
                                      z ->
                                          !a.G().contains(z)
                                              || s.isGranted(j, a.i(), s.ts.at(a.i()), z)
                                              || s.isVouched(j, a.i(), s.ts.at(a.i()), z),
                                      a.G())),
                          j ->
                              String.format(
                                  "j = %s, %s, %s",
                                  j,
                                  s.plist.at(a.i()).contains(j)
                                      ? "plist(" + a.i() + ") = " + s.plist.at(a.i())
                                      : "heard(" + a.i() + ") = " + s.heard.at(a.i()),
                                  Finite.first(
                                      z ->
                                          !(!a.G().contains(z)
                                              || s.isGranted(j, a.i(), s.ts.at(a.i()), z)
                                              || s.isVouched(j, a.i(), s.ts.at(a.i()), z)),
                                      z ->
                                          String.format(
                                              "z = %s, ts(%s) = %s, oks = %s, vouched = %s",
                                              z, a.i(), s.ts.at(a.i()), s.oks, s.vouched),
                                      a.G())),
                          s.plist.at(a.i()),
                          s.heard.at(a.i())))
              .and(
                  "forall f: PIDS :: f in fencers(i) => forall z: Zones :: z in G => granted?(f, i, ts(i), z)",
                  Finite.forAll(
                      f ->
                          !s.fencers.at(a.i()).contains(f)
                              || Finite.forAll(
                                  z ->
                                      !a.G().contains(z)
                                          || s.isGranted(f, a.i(), s.ts.at(a.i()), z),
                                  a.G()),
                      s.fencers.at(a.i())),
                  () ->
                      Finite.first(
                          f ->
                              !(!s.fencers.at(a.i()).contains(f)
                                  || Finite.forAll(
                                      z ->
                                          !a.G().contains(z)
                                              || s.isGranted(f, a.i(), s.ts.at(a.i()), z),
                                      a.G())),
                          f ->
                              String.format(
                                  "f = %s, fencers(%s) = %s, %s",
                                  f,
                                  a.i(),
                                  s.fencers.at(a.i()),
                                  Finite.first(
                                      z ->
                                          !(!a.G().contains(z)
                                              || s.isGranted(f, a.i(), s.ts.at(a.i()), z)),
                                      z ->
                                          String.format(
                                              "z = %s, ts(%s) = %s, oks = %s",
                                              z, a.i(), s.ts.at(a.i()), s.oks),
                                      a.G())),
                          s.fencers.at(a.i())));
      case ProtocolAction.release a ->
          Enabled.when(
              "RS subset crit_set(i)",
              s.crit_set.at(a.i()).containsAll(a.RS()),
              () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()));
      case ProtocolAction.withdraw a ->
          Enabled.when(
              "waits?(i)",
              s.isWaits(a.i()),
              () ->
                  String.format(
                      "want(%s) = %s, crit_set(%s) = %s",
                      a.i(), s.want.at(a.i()), a.i(), s.crit_set.at(a.i())));
      case ProtocolAction.fence a -> Enabled.TRUE;
      case ProtocolAction.vouch a ->
          Enabled.when(
                  "f in fencers(j)",
                  s.fencers.at(a.j()).contains(a.f()),
                  () -> "fencers(" + a.j() + ") = " + s.fencers.at(a.j()))
              .and(
                  "Request(asker := i, at := t) in reqs",
                  s.reqs.contains(new Request(a.i(), a.t())),
                  () -> "reqs = " + s.reqs)
              .and(
                  "not may_hold?(j, f, z)",
                  !s.isMayHold(a.j(), a.f(), a.z()),
                  () ->
                      s.crit_set.at(a.j()).contains(a.z())
                          ? "crit_set(" + a.j() + ") = " + s.crit_set.at(a.j())
                          : String.format(
                              "want(%s) = %s, ts(%s) = %s, oks = %s",
                              a.j(), s.want.at(a.j()), a.j(), s.ts.at(a.j()), s.oks));
      case ProtocolAction.witness a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(ProtocolAction action, States s) {
    return switch (action) {
      case ProtocolAction.request a ->
          s.with_clock(s.clock.with(a.i(), s.clock.at(a.i()) + 1))
              .with_ts(s.ts.with(a.i(), s.clock.at(a.i()) + 1))
              .with_want(s.want.with(a.i(), a.RS()))
              .with_parts(a.in_parts() ? Sets.add(a.i(), s.parts) : Sets.remove(a.i(), s.parts))
              .with_plist(s.plist.with(a.i(), a.P()))
              .with_reqs(Sets.add(new Request(a.i(), s.clock.at(a.i()) + 1), s.reqs));
      case ProtocolAction.known a -> s.with_plist(s.plist.with(a.i(), a.P()));
      case ProtocolAction.forget a ->
          s.with_heard(s.heard.with(a.i(), Sets.remove(a.j(), s.heard.at(a.i()))));
      case ProtocolAction.grant a ->
          s.with_clock(s.clock.with(a.j(), s.clock.at(a.j()) < a.t() ? a.t() : s.clock.at(a.j())))
              .with_heard(s.heard.with(a.j(), Sets.add(a.i(), s.heard.at(a.j()))))
              .with_oks(Sets.add(new Grant(a.j(), a.i(), a.t(), a.z()), s.oks));
      case ProtocolAction.enter a ->
          s.with_crit_set(s.crit_set.with(a.i(), Sets.union(s.crit_set.at(a.i()), a.G())));
      case ProtocolAction.release a ->
          s.with_want(s.want.with(a.i(), Sets.difference(s.want.at(a.i()), a.RS())))
              .with_crit_set(s.crit_set.with(a.i(), Sets.difference(s.crit_set.at(a.i()), a.RS())));
      case ProtocolAction.withdraw a -> s.with_want(s.want.with(a.i(), s.crit_set.at(a.i())));
      case ProtocolAction.fence a ->
          s.with_fencers(s.fencers.with(a.i(), Sets.add(a.f(), s.fencers.at(a.i()))));
      case ProtocolAction.vouch a ->
          s.with_vouched(Sets.add(new Grant(a.j(), a.i(), a.t(), a.z()), s.vouched));
      case ProtocolAction.witness a ->
          s.with_clock(s.clock.with(a.i(), s.clock.at(a.i()) < a.t() ? a.t() : s.clock.at(a.i())));
    };
  }
}
