package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.Persistent;
import org.starl.shape.Shapes;

final class PersistentRecipe extends LogicThread {

  private final Persistent<Integer> rooms;

  PersistentRecipe(GlobalVarHolder gvh) {
    super(gvh);
    rooms = gvh.plat.persistent("rooms cleaned", Shapes.INT, 0);
  }

  @Override
  public List<Object> callStarL() {
    while (rooms.get() < 5) {
      sleep(1_000); // it cleans a room
      rooms.set(rooms.get() + 1);
      await(rooms::isFlushed); // from now on a crash does not forget this room
    }
    return List.of("program " + gvh.id.boot() + ": " + rooms.get() + " rooms");
  }
}
