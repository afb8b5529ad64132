package org.starl.apps.recipes;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.GeocastReceipt;

/** A recipe of docs/primitives.md. */
final class BroadcastRecipe extends LogicThread {

  private final List<Object> heard = new ArrayList<>();
  private final Broadcast<String> news;

  BroadcastRecipe(GlobalVarHolder gvh) {
    super(gvh);
    news = new Broadcast<>(gvh, "news", Codec.text(), (from, text) -> heard.add(from + " " + text));
  }

  @Override
  public List<Object> callStarL() {
    GeocastReceipt sent = news.BCast("arrived", 5_000);
    await(sent::isComplete);
    heard.add(sent.acknowledgedBy().size() + " have it");
    sleep(5_000);
    return heard;
  }
}
