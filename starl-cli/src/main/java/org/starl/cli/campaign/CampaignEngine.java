package org.starl.cli.campaign;

import java.io.IOException;
import java.util.List;
import java.util.ServiceLoader;
import org.jspecify.annotations.Nullable;

/**
 * Runs a campaign, a sweep or an exploration, usually on many machines. Found by {@link ServiceLoader}, so the
 * command line depends on no engine.
 */
public interface CampaignEngine {

  /** Takes the rows of finished parts, on the thread that called {@link #run}. */
  interface Rows {

    /**
     * Takes the result of {@link SeedPart#run}; parts may come in any order, each once.
     *
     * @return whether the whole is decided: no further part is needed
     */
    boolean take(SeedPart part, List<String> lines);

    /** The last number of the result, once the whole is decided or all parts are taken. */
    long last();
  }

  /** The word after {@code --on}: lower case. */
  String name();

  /**
   * Runs {@code campaign}, split as the engine likes.
   *
   * @param master the engine's own address of the machines; empty for this one alone
   * @param cores of this machine to use, if it is the only one
   * @param parquet the folder to write the rows to as Parquet; null without
   * @throws org.starl.input.BadInput if {@code master} or {@code parquet} cannot be used
   * @throws IOException if the engine gives up; its message is one line
   */
  void run(String master, int cores, SeedPart campaign, @Nullable String parquet, Rows rows)
      throws InterruptedException, IOException;
}
