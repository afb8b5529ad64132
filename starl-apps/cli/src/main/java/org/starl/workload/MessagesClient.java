package org.starl.workload;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.comms.Receipt;
import org.starl.comms.Reliability;
import org.starl.id.RobotId;
import org.starl.time.Time;

/**
 * Robots send letters over {@code gvh.comms}: reliably to one robot, and best effort to one or all.
 * In each round a robot sends one letter, a few, or more than all windows hold, and is served when
 * they have been delivered. A second channel is closed in some rounds; in half of the others it closes
 * with letters under way, and opens again at once.
 */
final class MessagesClient extends Client {

  /** {@code source} of the letters' events. */
  static final String MAIL = "mail";

  /** Actions: a channel opens or closes. */
  static final String OPEN = "open";

  static final String CLOSE = "close";

  /** Action: a letter is sent, to this robot or all, on this channel, with this reliability. */
  static final String SEND = "send";

  /** Action: a letter is handled, with the logical clocks of its sender then and of the robot. */
  static final String HANDLE = "handle";

  /** Actions: the receipt of a letter says so. */
  static final String DELIVERED = "delivered";

  static final String FAILED = "failed";

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
    static final Codec<Letter> CODEC =
        Codec.of(
            (letter, out) -> {
              out.i32(letter.boot);
              out.i32(letter.number);
              out.i64(letter.clock);
            },
            in -> new Letter(in.i32(), in.i32(), in.i64()));
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
    Channel<Letter> channel = new Channel<>(MAIL, name, Letter.CODEC);
    gvh.trace.action(MAIL, OPEN, channel.name());
    return gvh.comms.open(channel, (from, letter) -> handled(channel, from, letter));
  }

  private void handled(Channel<Letter> channel, RobotId from, Letter letter) {
    long clock = gvh.comms.lamportClock().now();
    gvh.trace.action(
        MAIL, HANDLE, from, channel.name(), letter.boot(), letter.number(), letter.clock(), clock);
  }

  private void setSide(boolean isOpen) {
    Endpoint<Letter> open = side;
    if (isOpen && open == null) {
      side = open("side");
    } else if (!isOpen && open != null) {
      gvh.trace.action(MAIL, CLOSE, MAIL + "/side");
      open.close();
      side = null;
    }
  }

  @Override
  protected boolean obtain(int round) {
    setSide(round % SIDE_PERIOD != 1);
    letters.broadcast(write("*", "letters", "none"));
    RobotId to = robots.get(rng.nextInt(robots.size()));
    letters.send(to, write(to.name(), "letters", "none"));
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
    Letter letter = write(to.name(), channel, reliability.equals(BRIEF) ? "brief" : "default");
    Receipt receipt = endpoint.sendReliably(to, letter, reliability);
    receipt.whenSettled(() -> {
      String how = receipt.isDelivered() ? DELIVERED : FAILED;
      gvh.trace.action(MAIL, how, to, letter.boot(), letter.number());
    });
    return receipt;
  }

  private Letter write(String to, String channel, String reliability) {
    lastNumber++;
    Letter letter = new Letter(gvh.id.boot(), lastNumber, gvh.comms.lamportClock().tick());
    gvh.trace.action(
        MAIL, SEND, to, MAIL + "/" + channel, letter.boot(), letter.number(), reliability);
    return letter;
  }
}
