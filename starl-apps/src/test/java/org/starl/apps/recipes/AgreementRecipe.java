package org.starl.apps.recipes;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.SetAgreement;

/** A recipe of docs/primitives.md. */
final class AgreementRecipe extends LogicThread {

  private final SetAgreement<String> colour;

  AgreementRecipe(GlobalVarHolder gvh) {
    super(gvh);
    colour = new SetAgreement<>(gvh, "colour", Codec.text());
  }

  @Override
  public List<Object> callStarL() {
    do {
      colour.propose("the colour of " + gvh.id.name());
      await(() -> colour.decided().get().isDecided() || colour.failed().get());
    } while (!colour.decided().get().isDecided());
    return colour.decided().get() instanceof Decision.Decided<String> decided
        ? List.of(decided.value())
        : List.of();
  }
}
