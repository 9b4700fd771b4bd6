use rayon::prelude::*;

use super::{SparseVolume, hull::retain};
use crate::{
    lightfield::ViewStack,
    model::{ForwardModel, Projector, ViewId},
};

#[derive(Debug, Clone)]
pub struct Options {
    pub mart: bool,
    pub relaxation: f32,
    pub views_per_subset: usize,
    pub floor: Vec<f32>,
    pub prune_every: usize,
    pub prune_below: f32,
}

const CHUNK: usize = 4096;

pub fn pass(
    projector: &mut Box<dyn Projector + '_>,
    model: &dyn ForwardModel,
    views: &[ViewStack],
    order: &[ViewId],
    volume: &mut SparseVolume,
    o: &Options,
) {
    let lens: Vec<usize> = model.layouts().iter().map(|l| l.window.len()).collect();
    for (n, subset) in order.chunks(o.views_per_subset).enumerate() {
        let p: &dyn Projector = projector.as_ref();
        let factors: Vec<Vec<f32>> = subset
            .par_iter()
            .map(|&id| {
                let mut image = vec![0.0f32; lens[id.camera]];
                p.project(id, &volume.intensity, &mut image);
                let floor = o.floor[id.camera];
                for (x, &measured) in image.iter_mut().zip(views[id.camera].view(id.view)) {
                    let ratio = (measured.max(0.0) + floor) / (*x + floor);
                    *x = if o.mart { ratio.max(1e-6).ln() } else { ratio - 1.0 };
                }
                image
            })
            .collect();
        let step = o.relaxation / subset.len() as f32;
        volume.intensity.par_chunks_mut(CHUNK).enumerate().for_each(|(c, chunk)| {
            let mut sum = vec![0.0f32; chunk.len()];
            let start = c * CHUNK;
            for (id, factor) in subset.iter().zip(&factors) {
                p.back_project(*id, factor, start..start + chunk.len(), &mut sum);
            }
            for (e, s) in chunk.iter_mut().zip(sum) {
                *e *= if o.mart {
                    (step * s).clamp(-20.0, 3.0).exp()
                } else {
                    (1.0 + step * s).max(0.0)
                };
            }
        });
        if o.prune_every > 0 && (n + 1) % o.prune_every == 0 {
            let keep: Vec<bool> = volume.intensity.iter().map(|&e| e > o.prune_below).collect();
            projector.retain(&keep);
            retain(&mut volume.voxels, &keep);
            retain(&mut volume.intensity, &keep);
        }
    }
}
