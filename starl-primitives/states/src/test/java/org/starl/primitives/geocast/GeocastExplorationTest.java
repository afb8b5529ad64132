package org.starl.primitives.geocast;

import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.Everywhere;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.Visits;
import org.starl.primitives.geocast.GeocastMessage.Ack;
import org.starl.primitives.geocast.GeocastMessage.Copy;

/** All states of geocast's code on small instances. */
class GeocastExplorationTest {

  @ParameterizedTest
  @CsvSource({
    "robots=2 callers=1 casts=2 ticks=3, 9390",
    "robots=2 callers=1 outside=1 moves=2 ticks=3, 5112",
    "robots=2 moves=1 crashes=1, 21950",
    "robots=3 callers=1 outside=1 moves=1 ticks=3, 20444",
    "robots=3 callers=1 outside=1 moves=2 crashes=1, 18460",
    "robots=3 callers=1 outside=1 moves=1 broadcast=1, 76",
  })
  void robotsInTheAreaGetTheMessageOnce(String bounds, int states) {
    Visits.assertHolds(GeocastStates.SPACE, bounds, states);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "robots=2 ticks=3, 18582",
    "robots=2 callers=1 crashes=1 ticks=3, 25712",
  })
  void robotsInTheAreaGetTheMessageOnceInManyStates(String bounds, int states) {
    Visits.assertHolds(GeocastStates.SPACE, bounds, states);
  }

  /** A protocol with a planted bug. */
  private static class Broken extends GeocastProtocol<String> {
    final GeocastStates.Node node;

    Broken(ProcessId me, GeocastStates of, GeocastStates.Node node, GeocastSettings settings) {
      super(me, of.names(), settings, node);
      this.node = node;
    }
  }

  /** Makes a broken protocol. */
  private interface Maker {
    Broken make(ProcessId me, GeocastStates of, GeocastStates.Node node, GeocastSettings settings);
  }

  @Test
  void aReceiverThatForgetsAnOpenMessageIsFound() {
    assertFinds(
        "callers=1 casts=2",
        (me, of, node, settings) ->
            new Broken(me, of, node, settings) {
              @Override
              void forgetFinished(long nowNs) {
                delivered.clear();
              }
            },
        GeocastSpec.ONCE);
  }

  @Test
  void aReceiverThatDoesNotSubtractTheSkewIsFound() {
    assertFinds(
        "callers=1 ticks=3",
        copies(copy -> {
          long deadlineNs = copy.deadlineNs() + GeocastStates.TICK_NS;
          return new Copy<>(copy.id(), copy.area(), copy.startNs(), deadlineNs, copy.message());
        }),
        GeocastSpec.DEADLINE);
  }

  @Test
  void aReceiverThatDoesNotLookAtItsPlaceIsFound() {
    assertFinds(
        "callers=1 outside=1",
        copies(copy ->
            new Copy<>(
                copy.id(), new Everywhere(), copy.startNs(), copy.deadlineNs(), copy.message())),
        GeocastSpec.EXCLUSION);
  }

  @Test
  void aReceiverThatTakesEachMessageForALateOneIsFound() {
    assertFinds(
        "callers=1",
        copies(copy -> new Copy<>(copy.id(), copy.area(), 0, 1, copy.message())),
        GeocastSpec.INCLUSION);
  }

  @Test
  void aReceiverThatAcknowledgesWhatItDropsIsFound() {
    assertFinds(
        "callers=1 outside=1",
        (me, of, node, settings) ->
            new Broken(me, of, node, settings) {
              @Override
              void received(RobotId from, GeocastMessage<String> message, long nowNs) {
                super.received(from, message, nowNs);
                if (message instanceof Copy) {
                  node.acknowledge(from, new Ack<>(message.id()));
                }
              }
            },
        GeocastSpec.ACKNOWLEDGED);
  }

  @Test
  void aSenderThatCountsAnAcknowledgementForEachRobotIsFound() {
    assertFinds(
        "robots=3 callers=1",
        (me, of, node, settings) ->
            new Broken(me, of, node, settings) {
              @Override
              void received(RobotId from, GeocastMessage<String> message, long nowNs) {
                of.names().forEach(each -> super.received(each, message, nowNs));
              }
            },
        GeocastSpec.GCASTFLAG);
  }

  @Test
  void aSenderThatIsCompleteBeforeItsDeadlineIsFound() {
    assertFinds(
        "callers=1 ticks=1",
        (me, of, node, settings) ->
            new Broken(me, of, node, settings) {
              @Override
              void timer(long nowNs) {
                super.timer(nowNs + GeocastStates.TICK_NS);
              }
            },
        GeocastSpec.GCASTFLAG);
  }

  /** A receiver that reads other copies than were sent. */
  private static Maker copies(Function<Copy<String>, Copy<String>> read) {
    return (me, of, node, settings) ->
        new Broken(me, of, node, settings) {
          @Override
          void received(RobotId from, GeocastMessage<String> message, long nowNs) {
            boolean isCopy = message instanceof Copy;
            super.received(from, isCopy ? read.apply((Copy<String>) message) : message, nowNs);
          }
        };
  }

  private static void assertFinds(String bounds, Maker maker, String lemma) {
    GeocastStates broken =
        new GeocastStates(Visits.bounds(GeocastStates.SPACE, bounds)) {
          @Override
          GeocastProtocol<String> program(ProcessId me, Node node) {
            return maker.make(me, this, node, SETTINGS);
          }
        };
    Visits.assertFinds(new StateSearch<>(broken), lemma);
  }
}
