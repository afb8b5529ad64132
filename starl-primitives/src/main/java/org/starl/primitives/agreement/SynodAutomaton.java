// Generated from Synod_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.agreement;

import java.util.SortedSet;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Undefined;

/**
 * The automaton Synod_decls, executable.
 *
 * <p>The Synod: agreement on one value by ballots among acceptors (Lamport, "The part-time
 * parliament", ACM Transactions on Computer Systems 16(2), 1998).
 *
 * <p>A proposer prepares a ballot; acceptors promise to accept no lower one, and say what they have
 * accepted last. Once a quorum has promised, the proposer asks for votes on the value of the
 * highest vote among the promises, or, where there is none, on any value that somebody wishes for.
 * What a quorum has accepted in one ballot is chosen.
 *
 * <p>Messages are sets from which nothing is ever taken: so they may be lost, late, doubled and
 * reordered. An acceptor keeps what it promised and its vote across restarts, and so restart
 * changes neither; a proposer that crashes does nothing any more, since its robot comes back under
 * another id.
 *
 * <p>Assumed: any two quorums have a robot in common (majorities do: theory majorities), and no id
 * is used by two proposers (a ballot names its proposer). Java: org.starl.primitives.agreement, its
 * Synod, Proposer, Acceptor, Ballot; each run is replayed on this automaton: SynodConformance.
 */
public final class SynodAutomaton implements Automaton<SynodAutomaton.States, SynodAction> {

  /** The theory's name. */
  public static final String SYNOD_DECLS = "Synod_decls";

  private final BiPredicate<ProcessId, ProcessId> before;
  private final Predicate<SortedSet<RobotId>> quorum;

  /** Of the theory's parameters. */
  public SynodAutomaton(
      BiPredicate<ProcessId, ProcessId> before, Predicate<SortedSet<RobotId>> quorum) {
    this.before = before;
    this.quorum = quorum;
  }

  /** The rank of one attempt of one proposer. */
  public record Ballot(long round, ProcessId proposer) implements Comparable<Ballot> {

    @Override
    public int compareTo(Ballot that) {
      int order = Sets.compare(this.round, that.round);
      if (order == 0) {
        order = Sets.compare(this.proposer, that.proposer);
      }
      return order;
    }
  }

  public record Vote(Ballot ballot, Value value) implements Comparable<Vote> {

    @Override
    public int compareTo(Vote that) {
      int order = Sets.compare(this.ballot, that.ballot);
      if (order == 0) {
        order = Sets.compare(this.value, that.value);
      }
      return order;
    }
  }

  public enum Phase {
    IDLE,
    PREPARING,
    ACCEPTING
  }

  public record Promise(RobotId acceptor, Ballot ballot, Lift<Vote> told)
      implements Comparable<Promise> {

    @Override
    public int compareTo(Promise that) {
      int order = Sets.compare(this.acceptor, that.acceptor);
      if (order == 0) {
        order = Sets.compare(this.ballot, that.ballot);
      }
      if (order == 0) {
        order = Sets.compare(this.told, that.told);
      }
      return order;
    }
  }

  public record Accepted(RobotId acceptor, Ballot ballot) implements Comparable<Accepted> {

    @Override
    public int compareTo(Accepted that) {
      int order = Sets.compare(this.acceptor, that.acceptor);
      if (order == 0) {
        order = Sets.compare(this.ballot, that.ballot);
      }
      return order;
    }
  }

  /**
   * The states.
   *
   * @param round of each proposer's last ballot
   * @param promised of each acceptor, stable
   * @param vote of each acceptor, stable
   * @param decided what each robot knows
   * @param prepares messages that were ever sent
   */
  public record States(
      SortedSet<Value> proposed,
      Fun<ProcessId, Long> round,
      Fun<ProcessId, Phase> phase,
      Fun<RobotId, Lift<Ballot>> promised,
      Fun<RobotId, Lift<Vote>> vote,
      Fun<RobotId, Lift<Value>> decided,
      SortedSet<Ballot> prepares,
      SortedSet<Promise> promises,
      SortedSet<Vote> accepts,
      SortedSet<Accepted> accepteds,
      SortedSet<Value> decideds) {

    public Ballot ballot(ProcessId i) {
      return new Ballot(round.at(i), i);
    }

    public boolean isVotedAll(Ballot b, SortedSet<RobotId> Q) {
      return Finite.forAll(r -> !Q.contains(r) || accepteds.contains(new Accepted(r, b)), Q);
    }

    public boolean isVoted(RobotId r, Ballot c, Value v) {
      return accepteds.contains(new Accepted(r, c)) && accepts.contains(new Vote(c, v));
    }

    private States with_proposed(SortedSet<Value> proposed) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_round(Fun<ProcessId, Long> round) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_phase(Fun<ProcessId, Phase> phase) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_promised(Fun<RobotId, Lift<Ballot>> promised) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_vote(Fun<RobotId, Lift<Vote>> vote) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_decided(Fun<RobotId, Lift<Value>> decided) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_prepares(SortedSet<Ballot> prepares) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_promises(SortedSet<Promise> promises) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_accepts(SortedSet<Vote> accepts) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_accepteds(SortedSet<Accepted> accepteds) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }

    private States with_decideds(SortedSet<Value> decideds) {
      return new States(
          proposed, round, phase, promised, vote, decided, prepares, promises, accepts, accepteds,
          decideds);
    }
  }

  @Override
  public String theory() {
    return SYNOD_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Sets.emptyset(),
        Fun.always(0L),
        Fun.always(Phase.IDLE),
        Fun.always(new Lift.bottom<>()),
        Fun.always(new Lift.bottom<>()),
        Fun.always(new Lift.bottom<>()),
        Sets.emptyset(),
        Sets.emptyset(),
        Sets.emptyset(),
        Sets.emptyset(),
        Sets.emptyset());
  }

  public boolean isLess(Ballot b, Ballot c) {
    return b.round() < c.round()
        || (b.round() == c.round() && before.test(b.proposer(), c.proposer()));
  }

  /** r has promised nothing that keeps it from b. */
  public boolean isAllows(RobotId r, Ballot b, States s) {
    return !s.promised.at(r).isUp()
        || !isLess(b, Undefined.the("Synod_decls.starl:72:39", s.promised.at(r)));
  }

  /** r has promised b, and said that it has voted in no ballot above c. */
  public boolean isPromisedTo(RobotId r, Ballot b, Ballot c, States s) {
    return Finite.exists(
        m ->
            s.promises.contains(m)
                && m.acceptor().equals(r)
                && m.ballot().equals(b)
                && (!m.told().isUp()
                    || !isLess(c, Undefined.the("Synod_decls.starl:78:37", m.told()).ballot())),
        s.promises);
  }

  /** What the promises of Q let a proposer propose in ballot b. */
  public boolean isProposable(Ballot b, Value v, SortedSet<RobotId> Q, States s) {
    return (Finite.forAll(
                r -> !Q.contains(r) || s.promises.contains(new Promise(r, b, new Lift.bottom<>())),
                Q)
            && s.proposed.contains(v))
        || Finite.exists(
            m ->
                s.promises.contains(m)
                    && Q.contains(m.acceptor())
                    && m.ballot().equals(b)
                    && m.told().isUp()
                    && Undefined.the("Synod_decls.starl:86:5", m.told()).value().equals(v)
                    && Finite.forAll(
                        r ->
                            !Q.contains(r)
                                || isPromisedTo(
                                    r,
                                    b,
                                    Undefined.the("Synod_decls.starl:87:54", m.told()).ballot(),
                                    s),
                        Q),
            s.promises);
  }

  /** r will never vote in c, since it has promised a higher ballot and has not voted in c. */
  public boolean isCannotVote(RobotId r, Ballot c, States s) {
    return s.promised.at(r).isUp()
        && isLess(c, Undefined.the("Synod_decls.starl:101:36", s.promised.at(r)))
        && !s.accepteds.contains(new Accepted(r, c));
  }

  @Override
  public Enabled enabled(SynodAction action, States s) {
    return switch (action) {
      case SynodAction.wish a -> Enabled.TRUE;
      case SynodAction.prepare a ->
          Enabled.when(
              "n > round(i)",
              a.n() > s.round.at(a.i()),
              () -> "round(" + a.i() + ") = " + s.round.at(a.i()));
      case SynodAction.Prepared a ->
          Enabled.when(
                  "b in prepares", s.prepares.contains(a.b()), () -> "prepares = " + s.prepares)
              .and(
                  "allows?(r, b)",
                  () -> isAllows(a.r(), a.b(), s),
                  () ->
                      String.format(
                          "promised(%s) = %s, %s",
                          a.r(),
                          s.promised.at(a.r()),
                          a.b().round() < s.promised.at(a.r()).get().round()
                              ? String.format(
                                  "b.round = %s, %s.round = %s",
                                  a.b().round(),
                                  s.promised.at(a.r()).get(),
                                  s.promised.at(a.r()).get().round())
                              : String.format(
                                  "b.round = %s, %s.round = %s, b.proposer = %s, %s.proposer = %s",
                                  a.b().round(),
                                  s.promised.at(a.r()).get(),
                                  s.promised.at(a.r()).get().round(),
                                  a.b().proposer(),
                                  s.promised.at(a.r()).get(),
                                  s.promised.at(a.r()).get().proposer())));
      case SynodAction.Propose a ->
          Enabled.when(
                  "phase(i) = PREPARING",
                  s.phase.at(a.i()) == Phase.PREPARING,
                  () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()))
              .and("quorum?(Q)", quorum.test(a.Q()), () -> "Q = " + a.Q())
              .and(
                  "proposable?(ballot(i), v, Q)",
                  () -> isProposable(s.ballot(a.i()), a.v(), a.Q(), s),
                  () ->
                      !Finite.forAll(
                              r ->
                                  !a.Q().contains(r)
                                      || s.promises.contains(
                                          new Promise(r, s.ballot(a.i()), new Lift.bottom<>())),
                              a.Q())
                          ? Finite.first(
                              r ->
                                  !(!a.Q().contains(r)
                                      || s.promises.contains(
                                          new Promise(r, s.ballot(a.i()), new Lift.bottom<>()))),
                              r ->
                                  String.format(
                                      "r = %s, ballot(%s) = %s, promises = %s",
                                      r, a.i(), s.ballot(a.i()), s.promises),
                              a.Q())
                          : "proposed = " + s.proposed);
      case SynodAction.Accept a ->
          Enabled.when(
                  "Vote(ballot := b, value := v) in accepts",
                  s.accepts.contains(new Vote(a.b(), a.v())),
                  () -> "accepts = " + s.accepts)
              .and(
                  "allows?(r, b)",
                  () -> isAllows(a.r(), a.b(), s),
                  () ->
                      String.format(
                          "promised(%s) = %s, %s",
                          a.r(),
                          s.promised.at(a.r()),
                          a.b().round() < s.promised.at(a.r()).get().round()
                              ? String.format(
                                  "b.round = %s, %s.round = %s",
                                  a.b().round(),
                                  s.promised.at(a.r()).get(),
                                  s.promised.at(a.r()).get().round())
                              : String.format(
                                  "b.round = %s, %s.round = %s, b.proposer = %s, %s.proposer = %s",
                                  a.b().round(),
                                  s.promised.at(a.r()).get(),
                                  s.promised.at(a.r()).get().round(),
                                  a.b().proposer(),
                                  s.promised.at(a.r()).get(),
                                  s.promised.at(a.r()).get().proposer())));
      case SynodAction.chosen a ->
          Enabled.when(
                  "phase(i) = ACCEPTING",
                  s.phase.at(a.i()) == Phase.ACCEPTING,
                  () -> "phase(" + a.i() + ") = " + s.phase.at(a.i()))
              .and(
                  "Vote(ballot := ballot(i), value := v) in accepts",
                  s.accepts.contains(new Vote(s.ballot(a.i()), a.v())),
                  () ->
                      String.format(
                          "ballot(%s) = %s, accepts = %s", a.i(), s.ballot(a.i()), s.accepts))
              .and("quorum?(Q)", quorum.test(a.Q()), () -> "Q = " + a.Q())
              .and(
                  "voted_all?(ballot(i), Q)",
                  s.isVotedAll(s.ballot(a.i()), a.Q()),
                  () ->
                      Finite.first(
                          r ->
                              !(!a.Q().contains(r)
                                  || s.accepteds.contains(new Accepted(r, s.ballot(a.i())))),
                          r ->
                              String.format(
                                  "r = %s, ballot(%s) = %s, accepteds = %s",
                                  r, a.i(), s.ballot(a.i()), s.accepteds),
                          a.Q()));
      case SynodAction.Learn a ->
          Enabled.when(
              "v in decideds", s.decideds.contains(a.v()), () -> "decideds = " + s.decideds);
      case SynodAction.restart a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(SynodAction action, States s) {
    return switch (action) {
      case SynodAction.wish a -> s.with_proposed(Sets.add(a.v(), s.proposed));
      case SynodAction.prepare a ->
          s.with_round(s.round.with(a.i(), a.n()))
              .with_phase(s.phase.with(a.i(), Phase.PREPARING))
              .with_prepares(Sets.add(new Ballot(a.n(), a.i()), s.prepares));
      case SynodAction.Prepared a ->
          s.with_promised(s.promised.with(a.r(), new Lift.up<>(a.b())))
              .with_promises(Sets.add(new Promise(a.r(), a.b(), s.vote.at(a.r())), s.promises));
      case SynodAction.Propose a ->
          s.with_phase(s.phase.with(a.i(), Phase.ACCEPTING))
              .with_accepts(Sets.add(new Vote(s.ballot(a.i()), a.v()), s.accepts));
      case SynodAction.Accept a ->
          s.with_promised(s.promised.with(a.r(), new Lift.up<>(a.b())))
              .with_vote(s.vote.with(a.r(), new Lift.up<>(new Vote(a.b(), a.v()))))
              .with_accepteds(Sets.add(new Accepted(a.r(), a.b()), s.accepteds));
      case SynodAction.chosen a -> s.with_decideds(Sets.add(a.v(), s.decideds));
      case SynodAction.Learn a -> s.with_decided(s.decided.with(a.r(), new Lift.up<>(a.v())));
      case SynodAction.restart a -> s.with_decided(s.decided.with(a.r(), new Lift.bottom<>()));
    };
  }
}
