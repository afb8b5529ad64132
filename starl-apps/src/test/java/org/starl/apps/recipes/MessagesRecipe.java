package org.starl.apps.recipes;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.comms.Receipt;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;

final class MessagesRecipe extends LogicThread {

  private record Level(int percent) {}

  private static final Channel<Level> LEVELS =
      Channel.of(
          "levels",
          Shapes.of(Level.class, Shapes.part("percent", Shapes.INT, Level::percent), Level::new));
  private static final RobotId CHIEF = new RobotId("bot0");

  private final Map<RobotId, Level> heard = new TreeMap<>();
  private final Endpoint<Level> levels;
  private int percent = 100;

  MessagesRecipe(GlobalVarHolder gvh) {
    super(gvh);
    levels = gvh.comms.open(LEVELS, heard::put);
  }

  @Override
  public List<Object> callStarL() {
    every(
        500, () -> levels.broadcast(new Level(--percent))); // one may be lost: the next comes soon
    sleep(5_000);
    Receipt receipt = levels.sendReliably(CHIEF, new Level(percent)); // this one must arrive
    await(receipt::isSettled);
    return List.of(receipt.isDelivered(), heard.size());
  }
}
