package org.starl.workload;

import java.util.Optional;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.id.ProcessId;
import org.starl.primitives.ledger.Allocation;
import org.starl.primitives.ledger.Auction;
import org.starl.primitives.ledger.LedgerCall;
import org.starl.primitives.ledger.LedgerOutcome;
import org.starl.primitives.ledger.LedgerSettings;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.ledger.LedgerTask;
import org.starl.primitives.ledger.TaskId;
import org.starl.primitives.ledger.TaskLedger;
import org.starl.shape.Shapes;
import org.starl.time.Time;

/**
 * In each round a robot adds a task, and does the open one that is nearest to it: whichever robot added
 * that. So there is always one for each. Some claims are given back; tasks that a silent robot has begun
 * are reopened.
 */
final class LedgerClient extends Client {

  private static final String XID = "jobs";
  private static final long THINK_MS = 500;
  private static final int PLACES = 100;
  private static final int GIVE_BACK_ONE_OF = 8;
  private static final long LOOK_MS = 1_000;

  private static final long PROMPT_MS = 20_000;
  private static final int PROMPT_MESSAGES = 200;

  static final String AUCTION = "auction";

  static final Parameter ALLOCATION =
      Parameter.choice(
          "allocation",
          "whether a robot claims the nearest task at once (nearest) or bids for it first (auction)",
          "nearest",
          AUCTION);

  private static final long BIDS_MS = 300;

  private final TaskLedger<Integer> ledger;
  private final Auction auction;
  private final boolean isAuction;

  private LedgerClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    ledger = new TaskLedger<>(gvh, XID, Shapes.INT, gvh.id.participants(), settings(setup));
    auction = new Auction(gvh, XID, BIDS_MS);
    isAuction = setup.request().choice(ALLOCATION).equals(AUCTION);
  }

  private static LedgerSettings settings(Setup setup) {
    return LedgerSettings.DEFAULT.withDeadlineMs(setup.drawnDeadlineMs());
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new LedgerClient(gvh, setup));
    long leaseNs = LedgerSettings.DEFAULT.leaseMs() * Time.NS_PER_MS;
    long turnsNs = setup.robots() * Time.NS_PER_S / 2;
    setup
        .simulation()
        .monitor(() ->
            new LedgerSpec(setup.withinNs(), 2 * leaseNs + turnsNs + setup.withinNs())
                .patient(settings(setup)));
    setup.promise(PROMPT_MS, PROMPT_MESSAGES, false);
  }

  @Override
  protected void prepare() {
    await(() -> ledger.ready().get());
    for (TaskId left : ledger.held().get()) {
      told(ledger.finish(left)); // begun by an earlier program
    }
  }

  @Override
  protected boolean obtain(int round) {
    String source = gvh.id.name().name();
    TaskId added = new TaskId(source, ledger.added(source) + 1);
    if (told(ledger.add(added, rng.nextInt(PLACES))) != LedgerOutcome.DONE) {
      return false;
    }
    int here = rng.nextInt(PLACES);
    while (true) {
      reopenSilent();
      Optional<TaskId> nearest =
          Allocation.nearest(ledger.tasks().values(), place -> Math.abs(place - here));
      if (nearest.isEmpty()) {
        await(() -> ledger.tasks().values().stream().anyMatch(LedgerTask::isOpen), LOOK_MS);
        continue;
      }
      if (isAuction && !isWon(nearest.get(), here)) {
        continue;
      }
      LedgerOutcome outcome = told(ledger.claim(nearest.get()));
      if (outcome == LedgerOutcome.DONE && rng.nextInt(GIVE_BACK_ONE_OF) == 0) {
        outcome = told(ledger.giveBack(nearest.get()));
      } else if (outcome == LedgerOutcome.DONE) {
        outcome = told(ledger.begin(nearest.get()));
        if (outcome == LedgerOutcome.DONE) {
          pause(rng.nextLong(0, THINK_MS));
          return told(ledger.finish(nearest.get())) == LedgerOutcome.DONE;
        }
      }
      if (outcome == LedgerOutcome.LATE) {
        outcome = told(ledger.giveBack(nearest.get())); // of which it has no claim
      }
      if (outcome == LedgerOutcome.UNKNOWN) {
        return false;
      }
    }
  }

  private boolean isWon(TaskId id, int here) {
    LedgerTask<Integer> task = ledger.tasks().get(id);
    if (task == null) {
      return false;
    }
    auction.bid(task, Math.abs(task.what() - here));
    await(auction::isOver);
    return auction.isWon();
  }

  private void reopenSilent() {
    for (LedgerTask<Integer> task : ledger.tasks().values()) {
      ProcessId holder = task.holder();
      if (holder != null && task.isBegun() && ledger.isSilent(holder.robot())) {
        told(ledger.reopen(task.id()));
      }
    }
  }

  private LedgerOutcome told(LedgerCall call) {
    await(call::isDone);
    return call.outcome();
  }
}
