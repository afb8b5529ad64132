package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastId;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.random.Rng;

/**
 * Robots that stand and geocast to rectangles, of which they send a corner, width and height. Whoever
 * receives one puts it together again with its upper edge at the left one plus the height, as the
 * original StarL did.
 */
final class CrookedGeocast extends LogicThread {

  private static final String XID = "specimen";
  private static final Channel<GeocastMessage<Word>> CHANNEL =
      new Channel<>(GeocastFact.GEOCAST, XID, GeocastMessage.shape(Word.CODEC));
  private static final int CASTS = 6;
  private static final int COPIES = 8;
  private static final long BETWEEN_COPIES_MS = 200;
  private static final long NS_PER_MS = 1_000_000;

  private final boolean isMended;
  private final Rng rng;
  private final ProcessId me;
  private final Endpoint<GeocastMessage<Word>> endpoint;
  private final Set<GeocastId> delivered = new HashSet<>();

  /**
   * @param isMended whether the upper edge is the lower one plus the height
   */
  CrookedGeocast(GlobalVarHolder gvh, boolean isMended) {
    super(gvh);
    this.isMended = isMended;
    rng = gvh.plat.entropy.fork("specimen");
    me = ProcessId.first(gvh.id.name(), gvh.id.boot());
    endpoint = gvh.comms.open(CHANNEL, this::received);
  }

  @Override
  public List<Object> callStarL() {
    tell(new GeocastFact.Opened(me));
    await(gvh.gps::hasFix);
    sleep(500);
    for (int i = 1; i <= CASTS; i++) {
      sleep(rng.nextInt(1000));
      cast(new GeocastId(me, i));
    }
    return List.of();
  }

  private void cast(GeocastId id) {
    int x = rng.nextInt(3000);
    int y = rng.nextInt(2000);
    int width = 500 + rng.nextInt(1500);
    int height = 500 + rng.nextInt(1000);
    long dNs = COPIES * BETWEEN_COPIES_MS * NS_PER_MS;
    long startNs = gvh.plat.clock.nowNs();
    long deadlineNs = startNs + dNs;
    Rectangle area = new Rectangle(x, y, x + width, y + height);
    tell(new GeocastFact.do_geocast(id, area, dNs));
    List<String> names = new ArrayList<>();
    for (int number : new int[] {x, y, width, height}) {
      names.add(Integer.toString(number));
    }
    Word word = new Word("RECT", deadlineNs, names);
    for (int copy = 0; copy < COPIES; copy++) {
      tell(new GeocastFact.copy(id));
      endpoint.broadcast(new GeocastMessage.Copy<>(id, area, startNs, deadlineNs, word));
      sleep(BETWEEN_COPIES_MS);
    }
  }

  private void received(RobotId from, GeocastMessage<Word> message) {
    // It sends nothing else, and does not look at the tags.
    if (message instanceof GeocastMessage.Copy<Word> copy) {
      received(copy.id(), copy.message());
    }
  }

  private void received(GeocastId id, Word word) {
    double[] of = word.names().stream().mapToDouble(Double::parseDouble).toArray();
    double maxY = (isMended ? of[1] : of[0]) + of[3];
    Point at = gvh.gps.pose().at();
    boolean isInside =
        of[0] <= at.xMm() && at.xMm() <= of[0] + of[2] && of[1] <= at.yMm() && at.yMm() <= maxY;
    if (isInside && gvh.plat.clock.nowNs() <= word.number() && delivered.add(id)) {
      tell(new GeocastFact.deliver(id));
    }
  }

  private void tell(GeocastFact fact) {
    gvh.trace.action(CHANNEL.instance(), GeocastFact.SHAPE, fact);
  }
}
