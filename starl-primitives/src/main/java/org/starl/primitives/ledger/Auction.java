package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.part;
import static org.starl.time.Time.NS_PER_MS;

import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * Auctions of open tasks, one at a time: the robots bid their costs for a task, and after the time for bids
 * the cheapest claims it. {@code auction.bid(task, mm); await(auction::isOver);} and claim it if {@link
 * #isWon}. It saves claims that come too late and lets the nearest robot go, no more: if bids are lost two
 * robots may win, and then the log decides. Strand only.
 */
public final class Auction {

  /** Each bid is sent so often, evenly over the time for bids: it is best effort. */
  private static final int COPIES = 3;

  /**
   * A bid.
   *
   * @param claim the number of the task's claims so far: bids of an earlier auction do not count
   */
  record Bid(TaskId task, long claim, double cost) {
    static final Shape<Bid> SHAPE =
        Shapes.of(
            Bid.class,
            part("task", TaskId.SHAPE, Bid::task),
            part("claim", Shapes.LONG, Bid::claim),
            part("cost", Shapes.REAL, Bid::cost),
            Bid::new);
  }

  private final GlobalVarHolder gvh;
  private final Endpoint<Bid> endpoint;
  private final Timer timer;
  private final long stepNs;

  /** A bid of another robot, and when it came. */
  private record Heard(Bid bid, long atNs) {}

  // The latest one of each.
  private final SortedMap<RobotId, Heard> others = new TreeMap<>();
  private @Nullable Bid own;
  private long begunNs;
  private int copiesLeft;
  private boolean isOver = true;

  /**
   * @param xid the ledger's instance
   * @param bidsMs the time for bids, in ms, above 0; several message delays
   */
  public Auction(GlobalVarHolder gvh, String xid, long bidsMs) {
    if (bidsMs <= 0) {
      throw new IllegalArgumentException("auction: " + bidsMs + " ms for bids: expected above 0");
    }
    this.gvh = gvh;
    stepNs = bidsMs * NS_PER_MS / COPIES;
    timer = gvh.plat.timers.timer(this::expired);
    endpoint = gvh.comms.open(new Channel<>(LedgerFact.BIDS, xid, Bid.SHAPE), this::received);
  }

  /**
   * Bids for an open task, and gives up an earlier bid.
   *
   * @param cost such as the distance in mm, finite; the least wins, of equal ones the first robot by name
   */
  public void bid(LedgerTask<?> task, double cost) {
    own = new Bid(task.id(), task.claim(), cost);
    begunNs = gvh.plat.clock.nowNs();
    copiesLeft = COPIES;
    isOver = false;
    expired();
  }

  /** Whether the time for bids is over; true before the first bid. */
  public boolean isOver() {
    return isOver;
  }

  /** Whether no other robot has bid less, as far as this one heard; false before the end. */
  public boolean isWon() {
    Bid mine = own;
    return isOver
        && mine != null
        && others.entrySet().stream()
            .noneMatch(other -> isBetter(other.getKey(), other.getValue(), mine));
  }

  // An old bid does not count: its robot may have crashed before it claimed the task.
  private boolean isBetter(RobotId robot, Heard other, Bid mine) {
    Bid bid = other.bid();
    int byCost = Double.compare(bid.cost(), mine.cost());
    return other.atNs() >= begunNs - COPIES * stepNs
        && bid.task().equals(mine.task())
        && bid.claim() == mine.claim()
        && (byCost < 0 || (byCost == 0 && robot.compareTo(gvh.id.name()) < 0));
  }

  private void expired() {
    if (copiesLeft == 0) {
      isOver = true;
      return;
    }
    copiesLeft--;
    Bid bid = own;
    if (bid != null) {
      endpoint.broadcast(bid);
    }
    timer.set(gvh.plat.clock.nowNs() + stepNs);
  }

  private void received(RobotId from, Bid bid) {
    if (gvh.id.participants().contains(from)) {
      others.put(from, new Heard(bid, gvh.plat.clock.nowNs()));
    }
  }
}
