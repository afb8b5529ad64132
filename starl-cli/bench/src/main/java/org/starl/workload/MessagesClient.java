package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.comms.Receipt;
import org.starl.comms.Reliability;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.workload.MailFact.Care;

/**
 * Robots send letters over {@code gvh.comms}: reliably to one robot, and best effort to one or all.
 * In each round a robot sends one letter, a few, or more than all windows hold, and is served when
 * they have been delivered. A second channel is closed in some rounds; in half of the others it closes
 * with letters under way, and opens again at once.
 */
final class MessagesClient extends Client {

  private static final long THINK_MS = 500;

  /** Of letters that give up early. */
  static final Reliability BRIEF = new Reliability(100, 1.2, 500, 1_000, 5_000);

  /** A letter to a closed channel may hold back others to the same robot until it gives up. */
  private static final long PROMPT_MS = 500 + BRIEF.deadlineMs();

  private static final int PROMPT_MESSAGES = 40;

  private static final double MANY = 0.1;

  /** Of so many rounds the second channel is closed in one: not in the last of any course. */
  private static final int SIDE_PERIOD = 3;

  /** Until the second channel closes during a round, at most. */
  private static final long LATE_MS = 500;

  /** More than are tracked individually of a sender, or of a session. */
  private static final int MOST_LETTERS = 1_300;

  private static final int FEW_LETTERS = 4;

  /**
   * @param boot which start of the sender's program
   * @param number among the letters of this start, from 1
   * @param clock the sender's logical clock
   */
  record Letter(int boot, int number, long clock) {
    static final Shape<Letter> SHAPE =
        Shapes.of(
            Letter.class,
            Shapes.part("boot", Shapes.INT, Letter::boot),
            Shapes.part("number", Shapes.INT, Letter::number),
            Shapes.part("clock", Shapes.LONG, Letter::clock),
            Letter::new);
  }

  private final List<RobotId> robots;
  private final Endpoint<Letter> letters;
  private @Nullable Endpoint<Letter> side;

  /** Of the last letter on the channel side to each robot. */
  private final SortedMap<RobotId, Receipt> sides = new TreeMap<>();

  private int lastNumber;

  private MessagesClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    robots = gvh.id.participants().asList();
    letters = open("letters");
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new MessagesClient(gvh, setup));
    long arrivesNs = setup.isLossless() ? setup.delayNs() : MessagesSpec.NEVER;
    long withinNs = setup.withinNs() + BRIEF.deadlineMs() * Time.NS_PER_MS;
    setup.simulation().monitor(() -> new MessagesSpec(withinNs, arrivesNs));
    setup.promise(PROMPT_MS, PROMPT_MESSAGES, false);
  }

  private Endpoint<Letter> open(String name) {
    Channel<Letter> channel = new Channel<>(MailFact.SOURCE.name(), name, Letter.SHAPE);
    record(new MailFact.Opened(channel.instance()));
    return gvh.comms.open(channel, (from, letter) -> handled(channel, from, letter));
  }

  private void handled(Channel<Letter> channel, RobotId from, Letter letter) {
    long clock = gvh.comms.lamportClock().now();
    record(
        new MailFact.Handled(
            from, channel.instance(), letter.boot(), letter.number(), letter.clock(), clock));
  }

  private void setSide(boolean isOpen) {
    Endpoint<Letter> open = side;
    if (isOpen && open == null) {
      side = open("side");
    } else if (!isOpen && open != null) {
      record(new MailFact.Closed(channel("side")));
      open.close();
      side = null;
    }
  }

  @Override
  protected boolean obtain(int round) {
    setSide(round % SIDE_PERIOD != 1);
    letters.broadcast(write(Optional.empty(), "letters", Care.NONE));
    RobotId to = robots.get(rng.nextInt(robots.size()));
    letters.send(to, write(Optional.of(to), "letters", Care.NONE));
    if (side != null) {
      RobotId any = robots.get(rng.nextInt(robots.size()));
      RobotId at = rng.nextBoolean(0.5) ? to : any;
      sides.put(at, sendReliably(side, "side", at, BRIEF));
    }
    int number =
        rng.nextBoolean(MANY) ? 1 + rng.nextInt(MOST_LETTERS) : 1 + rng.nextInt(FEW_LETTERS);
    boolean isBrief = rng.nextBoolean(0.5) && !mayBeHeldBack(to);
    List<Receipt> receipts = new ArrayList<>();
    for (int i = 0; i < number; i++) {
      receipts.add(sendReliably(letters, "letters", to, isBrief ? BRIEF : Reliability.DEFAULT));
    }
    if (side != null && rng.nextBoolean(0.5)) {
      pause(rng.nextLong(0, LATE_MS));
      setSide(false);
      setSide(true);
    }
    await(() -> receipts.stream().allMatch(Receipt::isSettled));
    return receipts.stream().allMatch(Receipt::isDelivered);
  }

  /** Whether a letter whose channel may be closed there can hold back later ones for its whole life. */
  private boolean mayBeHeldBack(RobotId to) {
    Receipt side = sides.get(to);
    return side != null && !side.isSettled();
  }

  private Receipt sendReliably(
      Endpoint<Letter> endpoint, String channel, RobotId to, Reliability reliability) {
    Letter letter =
        write(Optional.of(to), channel, reliability.equals(BRIEF) ? Care.BRIEF : Care.DEFAULT);
    Receipt receipt = endpoint.sendReliably(to, letter, reliability);
    receipt.whenSettled(() -> {
      record(
          receipt.isDelivered()
              ? new MailFact.Delivered(to, letter.boot(), letter.number())
              : new MailFact.Failed(to, letter.boot(), letter.number()));
    });
    return receipt;
  }

  private Letter write(Optional<RobotId> to, String channel, Care care) {
    lastNumber++;
    Letter letter = new Letter(gvh.id.boot(), lastNumber, gvh.comms.lamportClock().tick());
    record(new MailFact.Mailed(to, channel(channel), letter.boot(), letter.number(), care));
    return letter;
  }

  private void record(MailFact fact) {
    gvh.trace.action(MailFact.SOURCE, MailFact.SHAPE, fact);
  }

  private static Instance channel(String xid) {
    return Instance.of(MailFact.SOURCE.name(), xid);
  }
}
