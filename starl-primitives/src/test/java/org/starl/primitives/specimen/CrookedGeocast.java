package org.starl.primitives.specimen;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.RegionText;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * Robots that stand and geocast to rectangles, of which they send a corner, width and height. Whoever
 * receives one puts it together again with its upper edge at the left one plus the height, as the
 * original StarL did.
 */
final class CrookedGeocast extends LogicThread {

  private static final String XID = "specimen";
  private static final String SOURCE = "geocast/" + XID;
  private static final int CASTS = 6;
  private static final int COPIES = 8;
  private static final long BETWEEN_COPIES_MS = 200;
  private static final long NS_PER_MS = 1_000_000;

  private final boolean isMended;
  private final Rng rng;
  private final Endpoint<Word> endpoint;
  private final Set<String> delivered = new TreeSet<>();

  /**
   * @param isMended whether the upper edge is the lower one plus the height
   */
  CrookedGeocast(GlobalVarHolder gvh, boolean isMended) {
    super(gvh);
    this.isMended = isMended;
    rng = gvh.plat.entropy.fork("specimen");
    endpoint = gvh.comms.open(new Channel<>("geocast", XID, Word.CODEC), this::received);
  }

  @Override
  public List<Object> callStarL() {
    gvh.trace.action(SOURCE, "open", gvh.id.name());
    await(gvh.gps::hasFix);
    sleep(500);
    for (int i = 1; i <= CASTS; i++) {
      sleep(rng.nextInt(1000));
      cast(gvh.id.name() + "#" + i);
    }
    return List.of();
  }

  private void cast(String id) {
    int x = rng.nextInt(3000);
    int y = rng.nextInt(2000);
    int width = 500 + rng.nextInt(1500);
    int height = 500 + rng.nextInt(1000);
    long dNs = COPIES * BETWEEN_COPIES_MS * NS_PER_MS;
    long deadlineNs = gvh.plat.clock.nowNs() + dNs;
    Rectangle area = new Rectangle(x, y, x + width, y + height);
    gvh.trace.action(SOURCE, "do_geocast", id, RegionText.format(area), dNs);
    List<String> names = new ArrayList<>(List.of(id));
    for (int number : new int[] {x, y, width, height}) {
      names.add(Integer.toString(number));
    }
    for (int copy = 0; copy < COPIES; copy++) {
      gvh.trace.action(SOURCE, "copy", id);
      endpoint.broadcast(new Word("RECT", deadlineNs, names));
      sleep(BETWEEN_COPIES_MS);
    }
  }

  private void received(RobotId from, Word word) {
    String id = word.names().get(0);
    double[] of = word.names().stream().skip(1).mapToDouble(Double::parseDouble).toArray();
    double maxY = (isMended ? of[1] : of[0]) + of[3];
    Point at = gvh.gps.pose().at();
    boolean isInside =
        of[0] <= at.xMm() && at.xMm() <= of[0] + of[2] && of[1] <= at.yMm() && at.yMm() <= maxY;
    if (isInside && gvh.plat.clock.nowNs() <= word.number() && delivered.add(id)) {
      gvh.trace.action(SOURCE, "deliver", id);
    }
  }
}
