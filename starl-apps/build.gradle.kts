plugins {
    application
    id("maven-publish")
}

description = "Applications, scenarios and the command line"

dependencies {
    implementation(project(":starl-core"))
    implementation(project(":starl-primitives"))
    implementation(project(":starl-sim"))
    implementation(project(":starl-android"))
    implementation(libs.picocli)
    implementation(libs.jackson.databind)
    implementation(libs.jsvg)
    testImplementation(libs.jackson.dataformat.yaml)
    testImplementation(libs.archunit)
    testImplementation(libs.json.schema.validator)
    testImplementation(libs.junit.platform.testkit)
    implementation(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

application {
    mainClass.set("org.starl.cli.Main")
    applicationName = "starl"
    // The simulator schedules virtual threads itself; java.lang must be open for that.
    applicationDefaultJvmArgs = listOf("--add-opens", "java.base/java.lang=ALL-UNNAMED")
}

tasks.withType<Jar>().configureEach {
    manifest {
        attributes(mapOf("Main-Class" to "org.starl.cli.Main", "Add-Opens" to "java.base/java.lang"))
    }
}
