package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.Participants;
import org.starl.primitives.registration.RegPrim;
import org.starl.primitives.registration.Registration;

/** A recipe of docs/primitives.md. */
final class RegistrationRecipe extends LogicThread {

  private final RegPrim reg;

  RegistrationRecipe(GlobalVarHolder gvh) {
    super(gvh);
    reg = new Registration(gvh, "crossing"); // a new M_Mutex(gvh, "crossing") would now use it
  }

  @Override
  public List<Object> callStarL() {
    do {
      reg.do_register();
      await(() -> reg.getList() != null || reg.failed().get());
    } while (reg.failed().get());
    Participants list = reg.getList();
    sleep(5_000);
    do {
      reg.unregister();
      await(() -> reg.isUnregistered() || reg.failed().get());
    } while (!reg.isUnregistered());
    return List.of(list != null && list.contains(gvh.id.name()), reg.getList() == null);
  }
}
