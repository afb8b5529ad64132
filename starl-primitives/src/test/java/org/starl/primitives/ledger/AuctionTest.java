package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Value;
import org.starl.sim.Simulation;

class AuctionTest {

  private static final LedgerTask<Value> TASK =
      new LedgerTask<>(new TaskId("jobs", 1), Value.EMPTY, 0, null, false);

  /** Bids after its pause, its number as the cost, and once more ten seconds later. */
  private static final class Bidder extends LogicThread {
    private final SortedMap<RobotId, List<Boolean>> won;

    Bidder(GlobalVarHolder gvh, SortedMap<RobotId, List<Boolean>> won) {
      super(gvh);
      this.won = won;
    }

    @Override
    public List<Object> callStarL() {
      Auction auction = new Auction(gvh, "jobs", 300);
      int number = gvh.id.participants().asList().indexOf(gvh.id.name());
      auction.bid(TASK, number);
      await(auction::isOver);
      boolean isFirst = auction.isWon();
      sleep(10_000);
      boolean isSecond = false;
      if (number > 0) { // the first robot bids no more
        auction.bid(TASK, number);
        await(auction::isOver);
        isSecond = auction.isWon();
      }
      won.put(gvh.id.name(), List.of(isFirst, isSecond));
      return List.of();
    }
  }

  @Test
  void theLeastBidWinsAndAnOldOneDoesNotCount() {
    SortedMap<RobotId, List<Boolean>> won = new TreeMap<>();
    Simulation.builder().seed(1).robots(3, gvh -> new Bidder(gvh, won)).build().run();
    assertThat(won.values())
        .containsExactly(List.of(true, false), List.of(false, true), List.of(false, false));
  }
}
