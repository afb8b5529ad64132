package org.starl.apps.fleet.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.ledger.LedgerTask;
import org.starl.primitives.ledger.TaskId;

class ChoiceTest {

  private static final ProcessId OTHER = ProcessId.first(new RobotId("bot1"), 1);

  private final Choice choice = new Choice();

  private static LedgerTask<Delivery> task(
      long number, int pick, int drop, @Nullable ProcessId holder) {
    return new LedgerTask<>(
        new TaskId("deliveries", number), new Delivery(0, pick, drop), 1, holder, holder != null);
  }

  /** A delivery is as far as the number of its station. */
  private Optional<Long> at(long nowNs, int shut, List<LedgerTask<Delivery>> tasks) {
    return choice
        .nearest(
            tasks, delivery -> delivery.stops().contains(shut), nowNs, each -> (double) each.pick())
        .map(TaskId::number);
  }

  @Test
  void theNearestOpenDeliveryIsChosen() {
    assertThat(at(0, -1, List.of(task(1, 5, 6, null), task(2, 3, 4, null), task(3, 1, 2, OTHER))))
        .contains(2L);
    assertThat(at(0, -1, List.of(task(3, 1, 2, OTHER)))).isEmpty();
  }

  @Test
  void oneThatHasAStationInCommonWithOneUnderWayIsPassedOver() {
    LedgerTask<Delivery> underWay = task(1, 1, 2, OTHER);
    assertThat(at(0, -1, List.of(underWay, task(2, 2, 3, null), task(3, 8, 9, null)))).contains(3L);
    assertThat(at(0, -1, List.of(underWay, task(2, 3, 1, null)))).isEmpty();
  }

  @Test
  void unlessThoseUnderWayStayTheSameForFiveMinutes() {
    List<LedgerTask<Delivery>> tasks = List.of(task(1, 1, 2, OTHER), task(2, 2, 3, null));
    assertThat(at(1, -1, tasks)).isEmpty();
    assertThat(at(Choice.UNDER_WAY_NS, -1, tasks)).isEmpty();
    assertThat(at(1 + Choice.UNDER_WAY_NS, -1, tasks)).contains(2L);
    // Another one is under way: the time begins anew.
    List<LedgerTask<Delivery>> later = List.of(task(3, 2, 7, OTHER), task(2, 2, 3, null));
    assertThat(at(2 + Choice.UNDER_WAY_NS, -1, later)).isEmpty();
  }

  @Test
  void oneThatADeadRobotMakesImpossibleIsNeverChosen() {
    List<LedgerTask<Delivery>> tasks = List.of(task(1, 1, 2, null), task(2, 5, 6, null));
    assertThat(at(0, 2, tasks)).contains(2L);
    assertThat(at(2 * Choice.UNDER_WAY_NS, 2, tasks.subList(0, 1))).isEmpty();
  }
}
