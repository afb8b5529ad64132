/**
 * What every command needs: the apps that it can run, its writers, signals, exit statuses, the
 * options that several commands have, and output files that appear whole or not at all.
 *
 * <p>May import: core, {@code org.starl.lang}, {@code org.starl.sim}, {@code org.starl.apps}, {@code
 * org.starl.workload}; no other part of the command line.
 */
@NullMarked
package org.starl.cli.command;

import org.jspecify.annotations.NullMarked;
