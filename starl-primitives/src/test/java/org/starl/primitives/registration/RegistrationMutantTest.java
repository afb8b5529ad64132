package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.chaos.Weather;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.spec.SpecReport;

/** Protocols that are wrong in one place: the harness must see each, or it proves nothing. */
@Tag("long")
class RegistrationMutantTest {

  private static final int SEEDS = 1_500;

  /** What is wrong, and which lemma must tell. */
  enum Mutant {
    FORGETFUL_ACCEPTOR(RegistrationSpec.AGREEMENT, town -> town.acceptorsForget = true),
    ANSWER_BEFORE_FLUSH(RegistrationSpec.AGREEMENT, town -> town.flushesLie = true),
    OWN_VALUE(RegistrationSpec.AGREEMENT, town -> town.tamper = Mutant::withoutVote),
    REUSED_BALLOT(RegistrationSpec.AGREEMENT, town -> town.ballotsCollide = true),
    DERIVED_FROM_AN_OLDER_VIEW(
        RegistrationSpec.KEEPS,
        town ->
            town.maker =
                (self, acceptors, settings, rng, link, port, now) ->
                    new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                      private View first = View.NONE;

                      @Override
                      View proposal(View decided, Change wanted, List<Value> wishes) {
                        first = first.number() == 0 ? decided : first;
                        View stale = new View(decided.number(), first.admitted());
                        return super.proposal(stale, wanted, wishes);
                      }
                    }),
    LIST_LACKS_MEMBER(
        RegistrationSpec.KEEPS,
        town ->
            town.maker =
                (self, acceptors, settings, rng, link, port, now) ->
                    new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                      @Override
                      View proposal(View decided, Change wanted, List<Value> wishes) {
                        SortedMap<ProcessId, Long> fewer = new TreeMap<>(decided.admitted());
                        fewer.remove(fewer.isEmpty() ? me() : fewer.firstKey());
                        View lacking = new View(decided.number(), fewer);
                        return super.proposal(lacking, wanted, wishes);
                      }
                    }),
    FENCER_LEAVES_AT_ONCE(
        RegistrationSpec.KEEPS,
        town ->
            town.maker =
                (self, acceptors, settings, rng, link, port, now) ->
                    new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                      @Override
                      View proposal(View decided, Change wanted, List<Value> wishes) {
                        View next = super.proposal(decided, wanted, wishes);
                        for (Confinement each : wanted.confine()) {
                          for (ProcessId fencer : each.fencers()) {
                            next = each.applyTo(next).without(fencer);
                          }
                        }
                        return next;
                      }
                    }),
    GHOST_OF_NOTHING(
        RegistrationSpec.KEEPS,
        town ->
            town.maker =
                (self, acceptors, settings, rng, link, port, now) ->
                    new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                      @Override
                      View proposal(View decided, Change wanted, List<Value> wishes) {
                        View next = super.proposal(decided, wanted, wishes);
                        return new View(next.number(), next.admitted());
                      }
                    }),
    READMIT(
        RegistrationSpec.FRESH,
        town ->
            town.maker =
                (self, acceptors, settings, rng, link, port, now) ->
                    new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                      private final List<ProcessId> seen = new ArrayList<>();

                      @Override
                      View proposal(View decided, Change wanted, List<Value> wishes) {
                        View next = super.proposal(decided, wanted, wishes);
                        SortedMap<ProcessId, Long> more = new TreeMap<>(next.admitted());
                        seen.forEach(id -> more.putIfAbsent(id, next.number()));
                        seen.addAll(decided.ids());
                        return new View(next.number(), more);
                      }
                    }),
    WHO_NEVER_ASKED(
        RegistrationSpec.SOUNDNESS,
        town ->
            town.maker =
                (self, acceptors, settings, rng, link, port, now) ->
                    new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                      @Override
                      View proposal(View decided, Change wanted, List<Value> wishes) {
                        View next = super.proposal(decided, wanted, wishes);
                        ProcessId unasked = new ProcessId(me().robot(), me().inc() + 1_000);
                        return next.contains(unasked) ? next : next.with(unasked);
                      }
                    });

    private final String lemma;
    private final Consumer<Town> change;

    Mutant(String lemma, Consumer<Town> change) {
      this.lemma = lemma;
      this.change = change;
    }

    private static SynodMessage withoutVote(SynodMessage message) {
      return message instanceof Promise m
          ? new Promise(m.number(), m.ballot(), null, m.wishes())
          : message;
    }
  }

  @ParameterizedTest
  @EnumSource
  void theSpecificationDetectsTheMutant(Mutant mutant) {
    assertSeen(mutant, mutant.lemma);
  }

  @ParameterizedTest
  @EnumSource(names = {"OWN_VALUE", "LIST_LACKS_MEMBER", "READMIT", "WHO_NEVER_ASKED"})
  void theMutantDeviatesFromTheTheory(Mutant mutant) {
    assertSeen(mutant, RegistrationAutomaton.REGISTRATION_DECLS);
  }

  private static void assertSeen(Mutant mutant, String lemma) {
    long seeds = 0;
    SpecReport report;
    do {
      seeds++;
      Life life = new Life(seeds);
      mutant.change.accept(life.town);
      report = life.live();
    } while (report.violations(lemma) == 0 && seeds < SEEDS);
    assertThat(report.violations(lemma)).as("%s, seeds 1..%d", mutant, seeds).isPositive();
  }

  @Test
  void refusedAdmissionsViolateRegistered() {
    assertThat(notRegistered(false)).isZero();
    assertThat(notRegistered(true)).isPositive();
  }

  /** The number of robots, of four, that are not registered within 2 s. */
  private static long notRegistered(boolean isWrong) {
    Town town = new Town(1, 4, 4, new RegistrationSpec(2_000_000_000L));
    town.weather = Weather.FAIR;
    if (isWrong) {
      town.maker =
          (self, acceptors, settings, rng, link, port, now) ->
              new RegistrationProtocol(self, acceptors, settings, rng, link, port, now) {
                @Override
                View proposal(View decided, Change wanted, List<Value> wishes) {
                  return decided.next();
                }
              };
    }
    town.startAll();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(4_000);
    return town.finish().violations(RegistrationSpec.REGISTERED);
  }
}
