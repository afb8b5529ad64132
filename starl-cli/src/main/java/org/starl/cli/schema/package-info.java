/**
 * {@code schema}: JSON schemas, with which editors complete and check scenario files, sweeps and
 * deployment files. They are made from the same forms of values that read the files.
 *
 * <p>May import: {@code org.starl.cli.command}, {@code org.starl.cli.request}, {@code
 * org.starl.cli.campaign}; core, {@code org.starl.sim}, {@code org.starl.apps}, {@code org.starl.robot}.
 */
@NullMarked
package org.starl.cli.schema;

import org.jspecify.annotations.NullMarked;
