package org.starl.apps.recipes;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.primitives.geocast.Geocast;
import org.starl.primitives.geocast.GeocastReceipt;

/** A recipe of docs/primitives.md. */
final class GeocastRecipe extends LogicThread {

  private final List<Object> heard = new ArrayList<>();
  private final Geocast<String> warnings;

  GeocastRecipe(GlobalVarHolder gvh) {
    super(gvh);
    warnings =
        new Geocast<>(gvh, "warnings", Codec.text(), (from, text) -> heard.add(from + " " + text));
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    GeocastReceipt sent = warnings.do_geocast("brakes", warnings.neighbourhood(1_500), 2_000);
    await(sent::isComplete); // at the latest after 2 s
    sleep(2_000);
    return heard;
  }
}
